// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/checkpoint/state_record.h>
#include <lumbricus/discretization/same_cell.h>

#include <deal.II/grid/filtered_iterator.h>

#include <istream>
#include <map>
#include <ostream>
#include <vector>

namespace lumbricus
{
  namespace
  {
    using Indices = std::vector<dealii::types::global_dof_index>;

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
    Vector solution(space.locally_owned,
                    space.locally_relevant,
                    space.communicator());
    solution = state.solution;

    Indices             indices(space.fe.n_dofs_per_cell());
    Indices             rest_indices(space.rest_fe.n_dofs_per_cell());
    std::vector<double> values(indices.size() + rest_indices.size());
    for (const auto &cell : space.dof_handler.active_cell_iterators() |
                              dealii::IteratorFilters::LocallyOwnedCell())
      {
        cell->get_dof_indices(indices);
        same_cell(cell, space.rest_dof_handler)->get_dof_indices(rest_indices);
        auto value = values.begin();
        for (const auto i : indices)
          *value++ = solution(i);
        for (const auto i : rest_indices)
          *value++ = state.rest_displacement(i);

        const CellKey key = cell->id().template to_binary<dim>();
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
      owned[cell->id().template to_binary<dim>()] = cell;

    Indices             indices(space.fe.n_dofs_per_cell());
    Indices             rest_indices(space.rest_fe.n_dofs_per_cell());
    std::vector<double> values(indices.size() + rest_indices.size());
    unsigned int        n_read = 0;
    CellKey             key;
    while (read_bits(in, key.data(), key.size()) &&
           read_bits(in, values.data(), values.size()))
      {
        const auto found = owned.find(key);
        if (found == owned.end())
          continue;
        const auto cell = found->second;
        cell->get_dof_indices(indices);
        same_cell(cell, space.rest_dof_handler)->get_dof_indices(rest_indices);
        auto value = values.begin();
        for (const auto i : indices)
          {
            if (space.locally_owned.is_element(i))
              state.solution(i) = *value;
            ++value;
          }
        for (const auto i : rest_indices)
          state.rest_displacement(i) = *value++;
        ++n_read;
      }
    return n_read;
  }
} // namespace lumbricus
