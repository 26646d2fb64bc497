// SPDX-License-Identifier: LGPL-2.1-or-later
#include "factor_kinds.h"

#include <lumbricus/linear/full_factor.h>

#include "condensed_factor.h"

namespace lumbricus
{
  InverseKind
  make_factors(const Tangent &tangent, const unsigned int kind)
  {
    const MPI_Comm comm        = tangent.space.communicator();
    constexpr auto n_condensed = CondensedFactor::accuracies.size();
    if (kind < n_condensed)
      {
        const auto &accuracy = CondensedFactor::accuracies[kind];
        return {accuracy.name,
                std::make_unique<CondensedFactor>(tangent, accuracy, comm)};
      }
    if (kind == n_condensed)
      return {FullFactor::name, std::make_unique<FullFactor>(tangent, comm)};
    return {};
  }
} // namespace lumbricus
