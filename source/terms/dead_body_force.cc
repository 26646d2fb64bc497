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
      prm.add_parameter("Force",
                        formulas,
                        "[N/mm^3] Three expressions in t, x, y, z, separated "
                        "by semicolons: the force per reference volume.");
    }

    void
    initialize(const std::string &name) override
    {
      force = vector_expression(name + "/Force", formulas);
    }

    std::vector<Expression>
    expressions() const override
    {
      return force;
    }

    void
    volume(const VolumePoint &point, VolumeResponse &response) const override
    {
      for (unsigned int i = 0; i < dim; ++i)
        response.b[i] = force[i].value(point.X, point.t);
    }

  private:
    std::string             formulas = "0; 0; 0";
    std::vector<Expression> force;
  };

  static const Register<VolumeTerm, DeadBodyForce>
    dead_body_force("dead body force",
                    "a force per reference volume in a fixed direction.");
} // namespace lumbricus
