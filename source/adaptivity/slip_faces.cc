// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/adaptivity/slip_faces.h>

namespace lumbricus
{
  bool
  at_slip_interface(const ParallelMesh::cell_iterator &cell,
                    const IsSlipInterface             &is_slip_interface)
  {
    for (const unsigned int f : cell->face_indices())
      if (!cell->at_boundary(f) &&
          is_slip_interface(cell->material_id(),
                            cell->neighbor(f)->material_id()))
        return true;
    return false;
  }



  bool
  coarser_across_interface(const ParallelMesh::active_cell_iterator &cell,
                           const IsSlipInterface &is_slip_interface)
  {
    for (const unsigned int f : cell->face_indices())
      if (!cell->at_boundary(f) && cell->neighbor(f)->has_children() &&
          is_slip_interface(cell->material_id(),
                            cell->neighbor(f)->material_id()))
        return true;
    return false;
  }
} // namespace lumbricus
