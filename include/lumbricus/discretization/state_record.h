// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_state_record_h
#define lumbricus_discretization_state_record_h

#include <lumbricus/discretization/mixed_space.h>

#include <iosfwd>

namespace lumbricus
{
  /**
   * Write u, p, u_ref and u_vol of the locally owned cells, bit by bit: a key
   * and 85 + 162 numbers a cell, 2 kB. Values at nodes that cells share are
   * there more than once, so that each cell can be read alone. Collective.
   */
  void
  write_cells(const MixedSpace &space, const State &state, std::ostream &out);

  /** Read those of the cells that are locally owned now. @return how many. */
  unsigned int
  read_cells(const MixedSpace &space, std::istream &in, State &state);
} // namespace lumbricus

#endif
