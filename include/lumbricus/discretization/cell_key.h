// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_cell_key_h
#define lumbricus_discretization_cell_key_h

#include <lumbricus/core/dimension.h>

#include <deal.II/grid/cell_id.h>

namespace lumbricus
{
  /** A cell of a mesh, the same whatever the partition. */
  using CellKey = dealii::CellId::binary_type;



  /** The key of @p cell, of any level. */
  template <typename CellIterator>
  CellKey
  cell_key(const CellIterator &cell)
  {
    return cell->id().template to_binary<dim>();
  }
} // namespace lumbricus

#endif
