// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/parameters/registry.h>
#include <lumbricus/parameters/vector_expression.h>
#include <lumbricus/terms/surface_term.h>

namespace lumbricus
{
  /** A traction T(t, X) per reference area, whatever the deformation. */
  class DeadTraction : public SurfaceTerm
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      traction.declare_parameter(
        prm,
        "[N/mm^2] Three expressions in t, x, y, z, separated by semicolons: "
        "the force per reference area.");
    }

    std::vector<Expression>
    expressions() const override
    {
      return traction.components();
    }

    void
    surface(const SurfacePoint &point, SurfaceResponse &response) const override
    {
      response.T = traction.value(point.X, point.t);
    }

  private:
    VectorExpression traction = {"Traction", "0; 0; 0"};
  };

  static const Register<BoundaryCondition, DeadTraction>
    dead_traction("dead traction",
                  "a force per reference area in a fixed direction.");
} // namespace lumbricus
