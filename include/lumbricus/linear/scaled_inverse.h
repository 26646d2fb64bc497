// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_scaled_inverse_h
#define lumbricus_linear_scaled_inverse_h

#include <deal.II/lac/full_matrix.h>

namespace lumbricus
{
  /**
   * Replace the square matrix @p A by its inverse,
   *
   *   A^(-1) = D (D A D)^(-1) D,
   *
   * where D is diagonal, of powers of two, so that the diagonal of D A D is from 1
   * to 4, or zero; of matrices whose diagonal is all of a size D is I. So unknowns of other units or of another stiffness are not taken
   * for singular because their pivots are small: those of a trial state of Newton's
   * method may be 1e16 times smaller than others.
   */
  void
  scaled_inverse(dealii::FullMatrix<double> &A);
} // namespace lumbricus

#endif
