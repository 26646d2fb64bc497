// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/parameters/registry.h>
#include <lumbricus/parameters/vector_expression.h>
#include <lumbricus/terms/volume_term.h>

namespace lumbricus
{
  /** A force b(t, X) per reference volume, whatever the deformation: a weight in
   * the air. */
  class DeadBodyForce : public VolumeTerm
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      force.declare_parameter(
        prm,
        "[N/mm^3] Three expressions in t, x, y, z, separated by semicolons: "
        "the force per reference volume.");
    }

    std::vector<Expression>
    expressions() const override
    {
      return force.components();
    }

    void
    volume(const VolumePoint &point, VolumeResponse &response) const override
    {
      response.b = force.value(point.X, point.t);
    }

  private:
    VectorExpression force = {"Force", "0; 0; 0"};
  };

  static const Register<VolumeTerm, DeadBodyForce>
    dead_body_force("dead body force",
                    "a force per reference volume in a fixed direction.");
} // namespace lumbricus
