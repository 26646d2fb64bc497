// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/parameters/expression.h>
#include <lumbricus/parameters/registry.h>
#include <lumbricus/terms/surface_term.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * A pressure P on the deformed surface, positive when it presses:
   *
   *   T = -P cof(F) N,   cof(F) = J F^(-T),
   *   dT_i/dF_kL = -P (n_i F^(-1)_Lk - n_k F^(-1)_Li),   n = cof(F) N.
   */
  class FollowerPressure : public SurfaceTerm
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      pressure.declare_parameter(
        prm,
        "[N/mm^2] An expression in t, x, y, z (reference position); positive "
        "presses onto the body.");
    }

    std::vector<Expression>
    expressions() const override
    {
      return {pressure};
    }

    bool
    symmetric() const override
    {
      return false;
    }

    std::string
    uniform_pressure() const override
    {
      return pressure.depends_on_place() ? "" : pressure.formula();
    }

    void
    surface(const SurfacePoint &point, SurfaceResponse &response) const override
    {
      const double P     = pressure.value(point.X, point.t);
      const auto   F_inv = invert(point.F);
      const auto   n     = determinant(point.F) *
                     dealii::Tensor<1, dim>(transpose(F_inv) * point.N);

      response.T = -P * n;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int k = 0; k < dim; ++k)
          for (unsigned int L = 0; L < dim; ++L)
            response.dT_dF[i][k][L] =
              -P * (n[i] * F_inv[L][k] - n[k] * F_inv[L][i]);
    }

  private:
    Expression pressure = {"Pressure", "0"};
  };

  static const Register<BoundaryCondition, FollowerPressure>
    follower_pressure("follower pressure",
                      "a pressure on the deformed surface, along its normal.");
} // namespace lumbricus
