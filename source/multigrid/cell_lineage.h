// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_multigrid_cell_lineage_h
#define lumbricus_multigrid_cell_lineage_h

#include <lumbricus/discretization/cell_key.h>
#include <lumbricus/discretization/mixed_space.h>

#include <deal.II/base/mpi.h>

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace lumbricus
{
  /** An owned active cell with its line of ancestors. */
  struct CellLineage
  {
    /** By level; the last is its own. */
    std::vector<CellKey> keys;
    /** Which child of keys[l] keys[l + 1] is. */
    std::vector<unsigned int> child;
    /** Of the cell of the unrefined mesh: four times the mean length of its
     * edges in each of its directions [mm]. */
    std::array<double, dim> extent;

    /** How often a cell of the unrefined mesh was cut to get it. */
    unsigned int
    level() const
    {
      return child.size();
    }
  };

  /** Of the owned active cells, in the order of the mesh. */
  std::vector<CellLineage>
  cell_lineages(const MixedSpace &space);

  /** The ranks that own a part of the cells that are split among ranks, the
   * lowest first. */
  using SplitCells = std::map<CellKey, std::vector<unsigned int>>;

  /** The split cells of all levels, on every rank. Collective. */
  SplitCells
  split_cells(const std::vector<CellLineage> &cells, const MPI_Comm comm);

  /** The node of the ancestor on @p level that vertex @p v of a cell is, in
   * the order of FE_Q(2), or -1. */
  int
  node_of_ancestor(const CellLineage &cell,
                   const unsigned int level,
                   const unsigned int v);

  /** What cells of a patch have in common: the cell of the unrefined mesh,
   * where they are in it, and their level. */
  using PatchKey = std::pair<CellKey, std::array<unsigned int, dim + 1>>;

  /** The patch of the ancestor on @p level. Where the cell of the unrefined
   * mesh is longer by more than @p thin in another direction, those above each
   * other make one patch, up to 8 of them in one thin direction or 4 in each of
   * two. */
  PatchKey
  patch_key(const CellLineage &cell,
            const unsigned int level,
            const double       thin);
} // namespace lumbricus

#endif
