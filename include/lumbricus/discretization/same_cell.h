// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_same_cell_h
#define lumbricus_discretization_same_cell_h

#include <lumbricus/core/dimension.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/grid/tria.h>

namespace lumbricus
{
  /** @p cell as a cell of @p dof_handler, which is on the same mesh. */
  template <typename CellIterator>
  dealii::DoFHandler<dim>::active_cell_iterator
  same_cell(const CellIterator            &cell,
            const dealii::DoFHandler<dim> &dof_handler)
  {
    return {&dof_handler.get_triangulation(),
            cell->level(),
            cell->index(),
            &dof_handler};
  }



  /** @p cell as a cell of the mesh, for FEValues that are to see its shape and
   * not whose unknowns it has. */
  template <typename CellIterator>
  dealii::Triangulation<dim>::cell_iterator
  mesh_cell(const CellIterator &cell)
  {
    return {&cell->get_triangulation(), cell->level(), cell->index()};
  }



  /** Which child of its parent @p cell is, which is not of the coarse mesh. */
  inline unsigned int
  child_number(const dealii::Triangulation<dim>::cell_iterator &cell)
  {
    const auto   parent = cell->parent();
    unsigned int c      = 0;
    while (parent->child(c) != cell)
      ++c;
    return c;
  }
} // namespace lumbricus

#endif
