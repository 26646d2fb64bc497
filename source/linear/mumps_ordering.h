// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_mumps_ordering_h
#define lumbricus_linear_mumps_ordering_h

#include <lumbricus/linear/mumps.h>

#include <deal.II/base/mpi.h>

#include <vector>

namespace lumbricus
{
  /** The position of every unknown, counted from one, where the cells' ones have
   * the @p positions and @p more come among them: each behind all others in its
   * row. Then what is left of its diagonal is what the whole gives, and not that of
   * the first few unknowns, beside which the rest would be lost in rounding. Those
   * of them that are @p not_eliminated come last. Collective. */
  std::vector<int>
  ordering_with(std::vector<int>                 positions,
                const MoreEntries               &more,
                const std::vector<unsigned int> &not_eliminated,
                const MPI_Comm                   comm);
} // namespace lumbricus

#endif
