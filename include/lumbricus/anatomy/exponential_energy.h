// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_anatomy_exponential_energy_h
#define lumbricus_anatomy_exponential_energy_h

#include <lumbricus/core/dimension.h>
#include <lumbricus/materials/material_law.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

namespace lumbricus
{
  /**
   * The energy of fibres that stiffen as they are strained,
   *
   *   psi = k1/(2 k2) (exp(k2 E^2) - 1),   E = F^T F : M - E_0,
   *
   * with a symmetric M that does not hang on F; k2 = 0 means k1/2 E^2.
   */
  struct ExponentialEnergy
  {
    double k1; ///< [N/mm^2]
    double k2; ///< [-]

    /** psi at the strain @p E [N/mm^2]. */
    double
    value(const double E) const;

    /** Add d psi/dF = 2 psi' F M to P and, where @p with_tangent, its derivative to
     * A; @p M is that of the strain @p E at @p F. */
    void
    add_stress(const dealii::Tensor<2, dim>          &F,
               const dealii::SymmetricTensor<2, dim> &M,
               const double                           E,
               const bool                             with_tangent,
               MaterialResponse                      &response) const;
  };
} // namespace lumbricus

#endif
