// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/parameters/registry.h>
#include <lumbricus/parameters/vector_expression.h>
#include <lumbricus/terms/volume_term.h>

namespace lumbricus
{
  /** b = rho_0 g(t), with the density rho_0 of the tissue at rest; and g for the
   * liquids. */
  class Weight : public VolumeTerm
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      acceleration.declare_parameter(
        prm,
        "[mm/s^2] Three expressions in the time t, separated by semicolons: the "
        "acceleration of gravity, the same everywhere. On earth it has 9810. It "
        "acts on the densities of tissues and liquids.");
    }

    std::vector<Expression>
    expressions() const override
    {
      return acceleration.components();
    }

    void
    volume(const VolumePoint &point, VolumeResponse &response) const override
    {
      response.b = point.density * gravity(point.t);
    }

    dealii::Tensor<1, dim>
    gravity(const LoadTime &t) const override
    {
      return acceleration.value(dealii::Point<dim>(), t);
    }

  private:
    VectorExpression acceleration = {"Gravity", "0; 0; 0"};
  };

  static const Register<VolumeTerm, Weight>
    weight("weight",
           "the weight of tissues, and of the liquids in chambers with and "
           "without cells, whose pressure it makes grow downwards.");
} // namespace lumbricus
