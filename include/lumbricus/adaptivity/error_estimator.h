// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_adaptivity_error_estimator_h
#define lumbricus_adaptivity_error_estimator_h

#include <lumbricus/core/dimension.h>
#include <lumbricus/parameters/parameter_owner.h>

#include <deal.II/base/tensor.h>

namespace lumbricus
{
  /**
   * Estimates the error of a discrete solution by how much a flux G, which is
   * continuous across faces in the exact one, jumps there. A new estimator is
   * another flux.
   */
  class ErrorEstimator : public ParameterOwner
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler & /*prm*/) override
    {}

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
  };
} // namespace lumbricus

#endif
