// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/expression.h>
#include <lumbricus/core/registry.h>
#include <lumbricus/core/vector_expression.h>
#include <lumbricus/fibres/cylindrical_frame.h>
#include <lumbricus/fibres/fibre_field.h>

#include <deal.II/base/patterns.h>

#include <cmath>
#include <vector>

namespace lumbricus
{
  /** f = d/|d| with a vector d(x, y, z) given by one formula a component. */
  class ExpressionFibres : public FibreField
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.declare_entry(
        "Formulas",
        "1; 0; 0",
        dealii::Patterns::Anything(),
        "[x; y; z] Three formulas for the components of a vector along the "
        "fibres, of any length but zero, separated by semicolons. They may use "
        "the reference position x, y, z and the number pi.");
      prm.add_action("Formulas",
                     [this](const std::string &text) { read(text); });
    }

    dealii::Tensor<1, dim>
    direction(const dealii::Point<dim> &X) const override
    {
      dealii::Tensor<1, dim> d;
      for (unsigned int i = 0; i < dim; ++i)
        d[i] = components[i].value(X, 0.);

      const double length = d.norm();
      AssertThrow(std::isfinite(length) && length > 0.,
                  ExcInput("Parameter '" + parameter +
                           "': the vector has no direction at the point " +
                           point_text(X) +
                           ", because its length is zero or not a number. "
                           "Change the formulas so that they are defined "
                           "wherever the tissue is."));
      return d / length;
    }

  private:
    void
    read(const std::string &text)
    {
      components = vector_expression(parameter, text);
    }

    const std::string       parameter = "vector expression/Formulas";
    std::vector<Expression> components;
  };



  static const Register<FibreField, ExpressionFibres>
    expression_fibres("vector expression",
                      "along a vector given by three formulas.");
} // namespace lumbricus
