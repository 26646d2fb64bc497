// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_adaptivity_cell_cost_h
#define lumbricus_adaptivity_cell_cost_h

#include <lumbricus/adaptivity/slip_faces.h>

namespace lumbricus
{
  /**
   * What a cell costs to assemble, by which the mesh is parted among the
   * ranks: 100 for wall and for liquid, which take the same within 5% with and
   * without muscles, and 155 for one with a face along which liquid slips,
   * because each of its entries goes to those of several other unknowns
   * (benchmarks/run.sh cell_cost). The same for all ranks and all runs, so
   * that a mesh is always parted alike.
   */
  unsigned int
  cell_cost(const ParallelMesh::cell_iterator &cell,
            const IsSlipInterface             &is_slip_interface);
} // namespace lumbricus

#endif
