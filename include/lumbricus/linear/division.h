// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_division_h
#define lumbricus_linear_division_h

#include <lumbricus/linear/free_numbering.h>
#include <lumbricus/linear/mumps.h>
#include <lumbricus/linear/rank_tree.h>

#include <deal.II/base/mpi.h>

#include <vector>

namespace lumbricus
{
  /** An unknown that several ranks share. */
  struct SharedUnknown
  {
    unsigned int number; ///< in the numbering of all
    unsigned int node;   ///< of the RankTree, where it is eliminated
  };



  /**
   * Who eliminates which unknowns of a sum of cells' matrices. What only one
   * rank's cells know is inside: that rank eliminates it without the others. The
   * rest is shared, and eliminated at the lowest node of the RankTree that is
   * above all ranks concerned. An unknown that no cell has comes together with
   * the last of its neighbours, or after it.
   */
  struct Division
  {
    /** For the unknowns in @p numbering that owned cells have beyond the first
     * @p n_left_out of each, and those in @p more. Collective. */
    Division(const CellUnknowns  &unknowns,
             const unsigned int   n_left_out,
             const FreeNumbering &numbering,
             const MoreEntries   &more,
             const RankTree      &tree,
             const MPI_Comm       comm);

    /** Places of the cells' unknowns that are inside, in their order. */
    std::vector<unsigned int> inside;
    /** Unknowns without cells that are inside, counted from 0. */
    std::vector<unsigned int> more_inside;
    /** All shared unknowns that this rank's entries have, in ascending order. */
    std::vector<SharedUnknown> shared;
    /** Places of the cells' unknowns among them, which come first. */
    std::vector<unsigned int> shared_places;
    /** Which of the entries that are common to all ranks this one adds. */
    std::vector<unsigned int> common_entries;
  };
} // namespace lumbricus

#endif
