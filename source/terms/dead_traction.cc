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
      prm.add_parameter("Traction",
                        formulas,
                        "[N/mm^2] Three expressions in t, x, y, z, separated "
                        "by semicolons: the force per reference area.");
    }

    void
    initialize(const std::string &name) override
    {
      traction = vector_expression(name + "/Traction", formulas);
    }

    std::vector<Expression>
    expressions() const override
    {
      return traction;
    }

    void
    surface(const SurfacePoint &point, SurfaceResponse &response) const override
    {
      for (unsigned int i = 0; i < dim; ++i)
        response.T[i] = traction[i].value(point.X, point.t);
    }

  private:
    std::string             formulas = "0; 0; 0";
    std::vector<Expression> traction;
  };

  static const Register<BoundaryCondition, DeadTraction>
    dead_traction("dead traction",
                  "a force per reference area in a fixed direction.");
} // namespace lumbricus
