// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/parameters/registry.h>
#include <lumbricus/terms/surface_term.h>

#include <deal.II/base/symmetric_tensor.h>

namespace lumbricus
{
  /**
   * What holds up a surface that moves, as mucus, mud or water do, in proportion
   * to the speed v = (u - u_last)/dt over the load step,
   *
   *   T = -D_t (v - (v . n) n) - D_n (v . n) n,   n = F^(-T) N/|F^(-T) N|,
   *
   *   dT/du = -(D_t (I - n x n) + D_n n x n)/dt,
   *   dT/dF = -(D_n - D_t) (n x v . dn/dF + (v . n) dn/dF),
   *   dn_i/dF_kL = -(I - n x n)_ij F^(-1)_Lj n_k,
   *
   * per area at rest. What the surface remembers is u_last.
   */
  class Drag : public SurfaceTerm
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      const dealii::Patterns::Double not_negative(0.);
      prm.add_parameter("Along the surface",
                        along,
                        "[N s/mm^3] Traction over the speed along the surface, "
                        "in the unit of time of the run.",
                        not_negative);
      prm.add_parameter("Against the surface",
                        against,
                        "[N s/mm^3] Traction over the speed along the normal.",
                        not_negative);
    }

    void
    check_parameters() const override
    {
      AssertThrow(along > 0. || against > 0.,
                  ExcParameter("Along the surface",
                               "is zero as 'Against the surface' is, so that "
                               "there is no drag. Set one of them."));
    }

    void
    surface(const SurfacePoint &point, SurfaceResponse &response) const override
    {
      if (!(point.dt > 0.))
        return;
      const auto v     = (point.u - point.history) / point.dt;
      const auto F_inv = invert(point.F);
      const dealii::Tensor<1, dim> m = transpose(F_inv) * point.N;
      const auto                   n = m / m.norm();
      const auto D     = tensor(n);
      response.T       = -(D * v);
      response.dT_du   = -D / point.dt;
      const auto f     = (against - along) * n;
      // (I - n x n) v and the columns of (I - n x n) F^(-T).
      const double                 v_n     = v * n;
      const dealii::Tensor<1, dim> v_along = v - v_n * n;
      for (unsigned int L = 0; L < dim; ++L)
        {
          dealii::Tensor<1, dim> G;
          for (unsigned int j = 0; j < dim; ++j)
            G[j] = F_inv[L][j];
          const double                 vG = v_along * G;
          const dealii::Tensor<1, dim> G_along = G - (G * n) * n;
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int k = 0; k < dim; ++k)
              response.dT_dF[i][k][L] =
                f[k] * (vG * n[i] + v_n * G_along[i]);
        }
    }

    bool
    symmetric() const override
    {
      return along == against;
    }

    std::vector<dealii::Tensor<1, dim>>
    elastic_directions(const SurfacePoint &point) const override
    {
      std::vector<dealii::Tensor<1, dim>> all;
      for (unsigned int i = 0; i < dim; ++i)
        all.push_back(tensor(point.N)[i]);
      return all;
    }

    bool
    depends_on_rate() const override
    {
      return true;
    }

    bool
    remembers() const override
    {
      return true;
    }

    void
    remember(const SurfacePoint     &point,
             dealii::Tensor<1, dim> &history) const override
    {
      history = point.u;
    }

  private:
    // D_t (I - n x n) + D_n n x n.
    dealii::Tensor<2, dim>
    tensor(const dealii::Tensor<1, dim> &n) const
    {
      return along *
               dealii::Tensor<2, dim>(
                 dealii::unit_symmetric_tensor<dim, double>()) +
             (against - along) * dealii::outer_product(n, n);
    }

    double along   = 0.;
    double against = 0.;
  };

  static const Register<BoundaryCondition, Drag>
    drag("drag", "what holds up a surface that moves, by its speed.");
} // namespace lumbricus
