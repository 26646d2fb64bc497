// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_state_record_h
#define lumbricus_discretization_state_record_h

#include <lumbricus/discretization/cell_key.h>
#include <lumbricus/discretization/cell_state.h>
#include <lumbricus/discretization/mixed_space.h>

#include <iosfwd>
#include <map>
#include <set>
#include <vector>

namespace lumbricus
{
  /**
   * Write u, p, u_ref and u_vol of the locally owned cells, bit by bit: a key
   * and 85 + 162 numbers a cell, 2 kB. Values at nodes that cells share are
   * there more than once, so that each cell can be read alone. Collective.
   */
  void
  write_cells(const MixedSpace &space, const State &state, std::ostream &out);

  /** How much write_cells() writes for a cell [bytes]. */
  constexpr std::size_t cell_record_size =
    sizeof(CellKey) + CellState::size * sizeof(double);



  /** Reads what write_cells() wrote. */
  class CellReader
  {
  public:
    /** For the cells of @p space that are locally owned now. */
    explicit CellReader(const MixedSpace &space);

    /** Read the values of those that are in @p in; the others are left out. */
    void
    read(std::istream &in, State &state);

    /** Whether every cell has been read, once. */
    bool
    is_complete() const;

    /** Whether all values that were read are finite. */
    bool
    is_finite() const;

  private:
    CellStateAccess     access;
    std::vector<double> values;
    bool                finite = true;
    bool                twice  = false;

    std::map<CellKey, dealii::DoFHandler<dim>::active_cell_iterator> missing;
    std::set<CellKey>                                                was_read;
  };
} // namespace lumbricus

#endif
