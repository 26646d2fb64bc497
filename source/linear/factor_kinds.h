// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_factor_kinds_h
#define lumbricus_linear_factor_kinds_h

#include <lumbricus/discretization/tangent.h>
#include <lumbricus/linear/approximate_inverse.h>

namespace lumbricus
{
  /**
   * The factorisation number @p kind for the pattern of @p tangent, from fast
   * to robust: those of CondensedFactor::accuracies, and FullFactor; without an
   * inverse where there is none left. Collective.
   */
  InverseKind
  make_factors(const Tangent &tangent, const unsigned int kind);
} // namespace lumbricus

#endif
