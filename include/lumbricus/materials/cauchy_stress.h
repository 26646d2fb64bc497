// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_materials_cauchy_stress_h
#define lumbricus_materials_cauchy_stress_h

#include <lumbricus/core/dimension.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

namespace lumbricus
{
  /** sigma = P F^T / J [N/mm^2], where @p P is the first Piola-Kirchhoff stress
   * at the deformation gradient @p F. */
  inline dealii::SymmetricTensor<2, dim>
  cauchy_stress(const dealii::Tensor<2, dim> &P,
                const dealii::Tensor<2, dim> &F)
  {
    return dealii::symmetrize(P * dealii::transpose(F) /
                              dealii::determinant(F));
  }
} // namespace lumbricus

#endif
