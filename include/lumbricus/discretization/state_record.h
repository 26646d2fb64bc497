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
   * Write what the locally owned cells have of @p state, bit by bit: a key and
   * the numbers of a CellLayout each, 2 to 3 kB. Values at nodes that cells
   * share are there more than once, so that each cell can be read alone.
   * Collective.
   */
  void
  write_cells(const MixedSpace &space, const State &state, std::ostream &out);

  /** How much write_cells() writes for a cell [bytes] of a state with so many
   * histories and earlier solutions. */
  constexpr std::size_t
  cell_record_size(const unsigned int n_histories, const unsigned int n_past)
  {
    return sizeof(CellKey) +
           CellLayout::size_of(n_histories, n_past) * sizeof(double);
  }



  /** Reads what write_cells() wrote. */
  class CellReader
  {
  public:
    /** For the cells of @p space that are locally owned now, into @p state,
     * which has the histories and the past of what is to be read. */
    CellReader(const MixedSpace &space, State &state);

    /** Read the values of those that are in @p in; the others are left out. */
    void
    read(std::istream &in);

    /** Whether every cell has been read, once. */
    bool
    is_complete() const;

    /** Whether all values that were read are finite. */
    bool
    is_finite() const;

  private:
    CellStateWriter     writer;
    std::vector<double> values;
    bool                finite = true;
    bool                twice  = false;

    std::map<CellKey, dealii::DoFHandler<dim>::active_cell_iterator> missing;
    std::set<CellKey>                                                was_read;
  };
} // namespace lumbricus

#endif
