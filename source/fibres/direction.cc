// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/fibres/fibre_field.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/patterns.h>

#include <cmath>
#include <vector>

namespace lumbricus
{
  /** f = d/|d| with the same vector d everywhere. */
  class ConstantFibres : public FibreField
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("Direction",
                        vector,
                        "[x, y, z] A vector along the fibres, of any length "
                        "but zero.",
                        dealii::Patterns::List(dealii::Patterns::Double(),
                                               dim,
                                               dim));
    }

    void
    check_parameters() const override
    {
      const double length = tensor().norm();
      AssertThrow(std::isfinite(length) && length > 0.,
                  ExcParameter("Direction",
                               "has no direction, because its length is zero "
                               "or not a finite number. Give a vector like "
                               "'1, 0, 0'."));
    }

    dealii::Tensor<1, dim>
    direction(const dealii::Point<dim> & /*X*/) const override
    {
      return tensor() / tensor().norm();
    }

  private:
    dealii::Tensor<1, dim>
    tensor() const
    {
      dealii::Tensor<1, dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = vector[d];
      return result;
    }

    std::vector<double> vector = {1., 0., 0.};
  };



  static const Register<FibreField, ConstantFibres>
    constant_fibres("direction", "along one given vector everywhere.");
} // namespace lumbricus
