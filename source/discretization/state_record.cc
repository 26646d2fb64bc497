// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/cell_key.h>
#include <lumbricus/discretization/cell_state.h>
#include <lumbricus/discretization/state_record.h>

#include <deal.II/grid/filtered_iterator.h>

#include <istream>
#include <map>
#include <ostream>
#include <vector>

namespace lumbricus
{
  namespace
  {
    template <typename T>
    void
    write_bits(std::ostream &out, const T *values, const std::size_t n)
    {
      out.write(reinterpret_cast<const char *>(values), n * sizeof(T));
    }



    template <typename T>
    bool
    read_bits(std::istream &in, T *values, const std::size_t n)
    {
      return static_cast<bool>(
        in.read(reinterpret_cast<char *>(values), n * sizeof(T)));
    }
  } // namespace



  void
  write_cells(const MixedSpace &space, const State &state, std::ostream &out)
  {
    const Vector solution = space.with_ghosts(state.solution);

    CellStateAccess     access(space);
    std::vector<double> values;
    for (const auto &cell : space.dof_handler.active_cell_iterators() |
                              dealii::IteratorFilters::LocallyOwnedCell())
      {
        access.read(cell, solution, state, values);
        const CellKey key = cell_key(cell);
        write_bits(out, key.data(), key.size());
        write_bits(out, values.data(), values.size());
      }
  }



  unsigned int
  read_cells(const MixedSpace &space, std::istream &in, State &state)
  {
    std::map<CellKey, dealii::DoFHandler<dim>::active_cell_iterator> owned;
    for (const auto &cell : space.dof_handler.active_cell_iterators() |
                              dealii::IteratorFilters::LocallyOwnedCell())
      owned[cell_key(cell)] = cell;

    CellStateAccess     access(space);
    std::vector<double> values(CellState::size);
    unsigned int        n_read = 0;
    CellKey             key;
    while (read_bits(in, key.data(), key.size()) &&
           read_bits(in, values.data(), values.size()))
      {
        const auto found = owned.find(key);
        if (found == owned.end())
          continue;
        access.write(found->second, values, state);
        ++n_read;
      }
    return n_read;
  }
} // namespace lumbricus
