// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_adaptivity_mark_where_h
#define lumbricus_adaptivity_mark_where_h

#include <lumbricus/core/dimension.h>

#include <deal.II/base/mpi.h>
#include <deal.II/distributed/tria.h>
#include <deal.II/grid/filtered_iterator.h>

namespace lumbricus
{
  /** A mesh that p4est parts among the ranks. */
  using ParallelMesh = dealii::parallel::distributed::Triangulation<dim>;



  /**
   * Mark for refinement the locally owned cells for which @p predicate holds.
   * @return whether there are any, on any rank. Collective.
   */
  template <typename Predicate>
  bool
  mark_where(ParallelMesh &triangulation, const Predicate &predicate)
  {
    unsigned int n_marked = 0;
    for (const auto &cell : triangulation.active_cell_iterators() |
                              dealii::IteratorFilters::LocallyOwnedCell())
      if (predicate(cell))
        {
          cell->clear_coarsen_flag();
          cell->set_refine_flag();
          ++n_marked;
        }
    return dealii::Utilities::MPI::sum(n_marked,
                                       triangulation.get_communicator()) > 0;
  }
} // namespace lumbricus

#endif
