// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/adaptivity/mesh_record.h>

#include <vector>

namespace lumbricus
{
  std::set<CellKey>
  refined_cells(const ParallelMesh &triangulation)
  {
    std::set<CellKey> refined;
    for (const auto &cell : triangulation.active_cell_iterators() |
                              dealii::IteratorFilters::LocallyOwnedCell())
      {
        ParallelMesh::cell_iterator ancestor =
          static_cast<const ParallelMesh::active_cell_iterator &>(cell);
        // Where a cell is known its ancestors are.
        while (ancestor->level() > 0)
          {
            ancestor = ancestor->parent();
            if (!refined.insert(cell_key(ancestor)).second)
              break;
          }
      }

    const std::vector<CellKey> mine(refined.begin(), refined.end());
    for (const auto &of_rank :
         dealii::Utilities::MPI::all_gather(triangulation.get_communicator(),
                                            mine))
      refined.insert(of_rank.begin(), of_rank.end());
    return refined;
  }



  void
  refine_cells(ParallelMesh &triangulation, const std::set<CellKey> &refined)
  {
    while (mark_where(triangulation, [&](const auto &cell) {
      return refined.count(cell_key(cell)) > 0;
    }))
      triangulation.execute_coarsening_and_refinement();
  }



  void
  coarsen_completely(ParallelMesh &triangulation)
  {
    while (triangulation.n_global_levels() > 1)
      {
        for (const auto &cell : triangulation.active_cell_iterators() |
                                  dealii::IteratorFilters::LocallyOwnedCell())
          cell->set_coarsen_flag();
        triangulation.execute_coarsening_and_refinement();
      }
  }
} // namespace lumbricus
