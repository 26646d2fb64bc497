// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/registry.h>
#include <lumbricus/terms/surface_term.h>

#include <deal.II/base/symmetric_tensor.h>

namespace lumbricus
{
  /**
   * Elastic bedding, T = -k u, or only against the displacement along the
   * reference normal, T = -k (u . N) N.
   */
  class Spring : public SurfaceTerm
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("Stiffness",
                        stiffness,
                        "[N/mm^3] Force per reference area and displacement.",
                        PositiveNumber());
      prm.add_parameter("Only along the normal",
                        only_normal,
                        "Whether the surface may slide along itself freely.");
    }

    void
    surface(const SurfacePoint &point, SurfaceResponse &response) const override
    {
      response.dT_du = -stiffness * directions(point.N);
      response.T     = response.dT_du * point.u;
    }

    std::vector<dealii::Tensor<1, dim>>
    elastic_directions(const SurfacePoint &point) const override
    {
      if (only_normal)
        return {point.N};
      std::vector<dealii::Tensor<1, dim>> all(dim);
      for (unsigned int i = 0; i < dim; ++i)
        all[i][i] = 1.;
      return all;
    }

  private:
    dealii::Tensor<2, dim>
    directions(const dealii::Tensor<1, dim> &N) const
    {
      return only_normal ? dealii::outer_product(N, N) :
                           dealii::Tensor<2, dim>(
                             dealii::unit_symmetric_tensor<dim, double>());
    }

    double stiffness   = 0.01;
    bool   only_normal = false;
  };

  static const Register<BoundaryCondition, Spring>
    spring("spring", "an elastic bedding that pulls the surface back.");
} // namespace lumbricus
