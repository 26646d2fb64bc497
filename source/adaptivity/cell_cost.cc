// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/adaptivity/cell_cost.h>

namespace lumbricus
{
  unsigned int
  cell_cost(const ParallelMesh::cell_iterator &cell,
            const IsSlipInterface             &is_slip_interface)
  {
    return at_slip_interface(cell, is_slip_interface) ? 155 : 100;
  }
} // namespace lumbricus
