// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_isotropic_function_h
#define lumbricus_core_isotropic_function_h

#include <lumbricus/core/dimension.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

namespace lumbricus
{
  /** The symmetric tensor that has the principal directions of @p A, and as its
   * principal values @p function of those. */
  template <typename Function>
  dealii::SymmetricTensor<2, dim>
  isotropic_function(const dealii::SymmetricTensor<2, dim> &A,
                     const Function                        &function)
  {
    dealii::SymmetricTensor<2, dim> result;
    for (const auto &eigen : dealii::eigenvectors(
           A, dealii::SymmetricTensorEigenvectorMethod::jacobi))
      result +=
        function(eigen.first) *
        dealii::symmetrize(dealii::outer_product(eigen.second, eigen.second));
    return result;
  }
} // namespace lumbricus

#endif
