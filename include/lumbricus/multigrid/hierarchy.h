// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_multigrid_hierarchy_h
#define lumbricus_multigrid_hierarchy_h

#include <lumbricus/discretization/cell_unknowns.h>

#include <deal.II/base/types.h>

#include <memory>
#include <vector>

namespace lumbricus
{
  /**
   * The unknowns of one mesh of a hierarchy. A cell that is split among ranks
   * on finer meshes is owned by the lowest of these, and known to all.
   */
  struct Level
  {
    /** Its unknowns: own or, on the finest mesh, those of the problem. */
    const CellUnknowns *unknowns = nullptr;
    /** None on the finest mesh. */
    std::unique_ptr<CellUnknowns> own;

    /** Cells of its unknowns that this rank knows, the owned ones first. */
    unsigned int n_cells = 0;
    /** Cells that it owns. */
    unsigned int n_owned_cells = 0;
    /** Of the cells that others own: the rank. */
    std::vector<unsigned int> owner;
    /** Of the same cells: a number that the cell has on all ranks. */
    std::vector<unsigned int> split_number;
    /** Of the owned cells that others know: that number, and the cell. */
    std::vector<std::pair<unsigned int, unsigned int>> split_cells;

    /** Of each owned cell: the cell on the next coarser mesh. */
    std::vector<unsigned int> parent;
    /** Which of its children this one is; -1 where it is the same cell. */
    std::vector<int> child;

    /** The owned cells in patches for the smoother: stacks through what is
     * thin, see Hierarchy::reinit(). */
    std::vector<std::vector<unsigned int>> patches;

    /** Of each owned unknown the place on the finest mesh; invalid for a
     * pressure, which is not among those. Empty for the finest mesh itself. */
    std::vector<unsigned int> on_finest;

    /** On all ranks. */
    dealii::types::global_dof_index n_unknowns = 0;
  };



  /**
   * The meshes of geometric multigrid, by global coarsening: mesh l has, in
   * place of all cells finer than l, their ancestors of level l.
   *
   * No mesh or DoFHandler is made for that. The nodes of a refined Q2 cell are
   * the vertices of its children, so an unknown of a coarse mesh is one of the
   * finest mesh too, and is constrained there as here: at supports and at
   * an interface with slip the node is the same, and a hanging node of a
   * coarse mesh lies between cells that are not refined on the finest. A node
   * that hangs on the finest mesh only has an equal there that does not.
   */
  class Hierarchy
  {
  public:
    /**
     * Make the levels of the mesh of @p space, with @p unknowns on the finest.
     * The coarsest is the finest of those with at most @p n_coarsest unknowns,
     * or the mesh without refinement. Where a cell of the unrefined mesh is
     * thin, that is longer by more than @p thin in another direction, its
     * descendants that lie above each other make one patch. Collective.
     */
    void
    reinit(const MixedSpace   &space,
           const CellUnknowns &unknowns,
           const unsigned int  n_coarsest,
           const double        thin);

    /** How many meshes there are, with the finest. */
    unsigned int
    n_levels() const
    {
      return levels.size();
    }

    /** The coarsest is 0. */
    const Level &
    level(const unsigned int l) const
    {
      return levels[l];
    }

  private:
    std::vector<Level> levels;
  };
} // namespace lumbricus

#endif
