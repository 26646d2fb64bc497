// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_adaptivity_jump_estimator_h
#define lumbricus_adaptivity_jump_estimator_h

#include <lumbricus/adaptivity/error_estimator.h>
#include <lumbricus/core/dimension.h>

#include <deal.II/base/tensor.h>

namespace lumbricus
{
  /**
   * Estimates the error of a discrete solution by how much a flux G, which is
   * continuous across faces in the exact one, jumps there: cell K adds
   *
   *   eta_K^2 = 1/2 sum_F h_F / (2 p) int_F |[G N]|^2 dA  [N^2/mm],
   *
   * over its faces F inside the body of diameter h_F, p = 2, and the relative
   * error of G is sqrt(sum eta_K^2 / int |G|^2 dV). A new estimator of this kind is
   * another flux.
   */
  class JumpEstimator : public ErrorEstimator
  {
  public:
    /**
     * The flux [N/mm^2] at a point with the deformation gradient @p F and the
     * first Piola-Kirchhoff stress @p P, in a tissue of shear modulus @p mu.
     */
    virtual dealii::Tensor<2, dim>
    flux(const double                  mu,
         const dealii::Tensor<2, dim> &F,
         const dealii::Tensor<2, dim> &P) const = 0;

    /** Whether the flux is continuous between different tissues too. */
    virtual bool
    continuous_between_tissues() const = 0;

    ErrorEstimate
    estimate(EstimatedState &state) const override;
  };
} // namespace lumbricus

#endif
