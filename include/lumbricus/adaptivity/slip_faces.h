// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_adaptivity_slip_faces_h
#define lumbricus_adaptivity_slip_faces_h

#include <lumbricus/adaptivity/mark_where.h>

#include <deal.II/base/types.h>

#include <functional>

namespace lumbricus
{
  /** Whether liquid slips along the wall between cells of two material ids. */
  using IsSlipInterface = std::function<bool(const dealii::types::material_id,
                                             const dealii::types::material_id)>;

  /** Whether liquid slips along a face of @p cell. */
  bool
  at_slip_interface(const ParallelMesh::cell_iterator &cell,
                    const IsSlipInterface             &is_slip_interface);

  /**
   * Whether @p cell is coarser than a neighbour across a slip interface: it is
   * to be refined, so that the two sides can share nodes pair by pair.
   */
  bool
  coarser_across_interface(const ParallelMesh::active_cell_iterator &cell,
                           const IsSlipInterface &is_slip_interface);
} // namespace lumbricus

#endif
