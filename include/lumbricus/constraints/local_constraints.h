// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_constraints_local_constraints_h
#define lumbricus_constraints_local_constraints_h

#include <deal.II/base/config.h>
#include <deal.II/base/index_set.h>
#include <deal.II/lac/affine_constraints.h>

namespace lumbricus
{
  /**
   * Constraints without any line yet, that may get lines for the unknowns
   * @p stored; of these the rank owns the unknowns @p owned. From version 9.6
   * on deal.II wants to know both, before it took the first alone.
   */
  inline dealii::AffineConstraints<double>
  local_constraints([[maybe_unused]] const dealii::IndexSet &owned,
                    const dealii::IndexSet                  &stored)
  {
#if DEAL_II_VERSION_GTE(9, 6, 0)
    return dealii::AffineConstraints<double>(owned, stored);
#else
    return dealii::AffineConstraints<double>(stored);
#endif
  }
} // namespace lumbricus

#endif
