// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/checkpoint/mesh_record.h>

#include <deal.II/grid/filtered_iterator.h>

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
            if (!refined.insert(ancestor->id().template to_binary<dim>())
                   .second)
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
    for (bool complete = false; !complete;)
      {
        unsigned int n_marked = 0;
        for (const auto &cell : triangulation.active_cell_iterators() |
                                  dealii::IteratorFilters::LocallyOwnedCell())
          if (refined.count(cell->id().template to_binary<dim>()) > 0)
            {
              cell->set_refine_flag();
              ++n_marked;
            }
        complete =
          dealii::Utilities::MPI::sum(n_marked,
                                      triangulation.get_communicator()) == 0;
        if (!complete)
          triangulation.execute_coarsening_and_refinement();
      }
  }
} // namespace lumbricus
