// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/fibres/fibre_field.h>
#include <lumbricus/parameters/registry.h>
#include <lumbricus/parameters/vector_expression.h>

#include <cmath>
#include <string>

#include "cylindrical_frame.h"

namespace lumbricus
{
  /** f = d/|d| with a vector d(x, y, z) given by one formula a component. */
  class ExpressionFibres : public FibreField
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      vector.declare_parameter(
        prm,
        "[x; y; z] Three formulas for the components of a vector along the "
        "fibres, of any length but zero, separated by semicolons. They may use "
        "the reference position x, y, z and the number pi.");
    }

    void
    initialize(const std::string &section,
               const Geometry & /*geometry*/) override
    {
      parameter = section + "/" + vector.parameter();
    }

    dealii::Tensor<1, dim>
    direction(const dealii::Point<dim> &X) const override
    {
      const dealii::Tensor<1, dim> d      = vector.value(X, 0.);
      const double                 length = d.norm();
      AssertThrow(std::isfinite(length) && length > 0.,
                  ExcInput(about_parameter(
                    parameter,
                    ": the vector has no direction at the point " +
                      point_text(X) +
                      ", because its length is zero or not a number. Change "
                      "the formulas so that they are defined wherever the "
                      "tissue is.")));
      return d / length;
    }

  private:
    VectorExpression vector = {"Formulas", "1; 0; 0"};
    std::string      parameter;
  };



  static const Register<FibreField, ExpressionFibres>
    expression_fibres("vector expression",
                      "along a vector given by three formulas.");
} // namespace lumbricus
