// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/cell_state.h>
#include <lumbricus/discretization/same_cell.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace lumbricus
{
  namespace
  {
    void
    get_indices(const MixedSpace                                    &space,
                const dealii::DoFHandler<dim>::active_cell_iterator &cell,
                std::vector<dealii::types::global_dof_index>        &indices,
                std::vector<dealii::types::global_dof_index> &rest_indices)
    {
      cell->get_dof_indices(indices);
      same_cell(cell, space.rest_dof_handler)->get_dof_indices(rest_indices);
    }



    // Call function(entry) for what a solution has on a cell, in the order of
    // CellLayout.
    template <typename Function>
    void
    for_each_entry(const MixedSpace                                   &space,
                   const std::vector<dealii::types::global_dof_index> &indices,
                   const Function                                     &function)
    {
      for (const auto &component : space.displacement_dof)
        for (const unsigned int i : component)
          function(indices[i]);
      for (const unsigned int i : space.pressure_dof)
        function(indices[i]);
    }
  } // namespace



  CellLayout::CellLayout(const State &state)
  {
    unsigned int end          = 0;
    const auto   add_solution = [&]() {
      displacements.push_back(end);
      pressures.push_back(end + pressure_begin);
      end += n_solution;
    };
    add_solution();
    for (const auto &history : state.histories)
      {
        names.push_back(history.first);
        displacements.push_back(end);
        end += n_displacements;
      }
    for (unsigned int k = 0; k < state.past.size(); ++k)
      add_solution();
  }



  unsigned int
  CellLayout::size() const
  {
    return size_of(names.size(), pressures.size() - 1);
  }



  unsigned int
  CellLayout::begin_of(const NodalHistory &history) const
  {
    const auto found = std::find(names.begin(), names.end(), history.name());
    Assert(found != names.end(), dealii::ExcInternalError());
    return displacements[1 + (found - names.begin())];
  }



  const std::vector<unsigned int> &
  CellLayout::displacement_begins() const
  {
    return displacements;
  }



  const std::vector<unsigned int> &
  CellLayout::pressure_begins() const
  {
    return pressures;
  }



  CellStateReader::CellStateReader(const MixedSpace &space, const State &state)
    : layout(state)
    , space(space)
    , state(state)
    , indices(space.fe.n_dofs_per_cell())
    , rest_indices(space.rest_fe.n_dofs_per_cell())
  {
    // Copies have no ghost entries, as one of these would when they move.
    relevant.reserve(1 + state.past.size());
    relevant.push_back(space.with_ghosts(state.solution));
    for (const State::Past &earlier : state.past)
      relevant.push_back(space.with_ghosts(earlier.solution));
  }



  void
  CellStateReader::read(
    const dealii::DoFHandler<dim>::active_cell_iterator &cell,
    std::vector<double>                                 &values)
  {
    get_indices(space, cell, indices, rest_indices);
    values.resize(layout.size());
    auto       value         = values.begin();
    const auto read_solution = [&](const Vector &solution) {
      for_each_entry(space,
                     indices,
                     [&](const dealii::types::global_dof_index i) {
                       *value++ = solution(i);
                     });
    };
    read_solution(relevant.front());
    for (const auto &[name, vector] : state.histories)
      for (const auto &component : space.rest_dof)
        for (const unsigned int i : component)
          *value++ = vector(rest_indices[i]);
    for (unsigned int k = 1; k < relevant.size(); ++k)
      read_solution(relevant[k]);
  }



  CellStateWriter::CellStateWriter(const MixedSpace &space, State &state)
    : layout(state)
    , space(space)
    , state(state)
    , indices(space.fe.n_dofs_per_cell())
    , rest_indices(space.rest_fe.n_dofs_per_cell())
  {}



  void
  CellStateWriter::write(
    const dealii::DoFHandler<dim>::active_cell_iterator &cell,
    const std::vector<double>                           &values)
  {
    get_indices(space, cell, indices, rest_indices);
    AssertDimension(values.size(), layout.size());
    auto       value          = values.begin();
    const auto write_solution = [&](Vector &solution) {
      for_each_entry(space,
                     indices,
                     [&](const dealii::types::global_dof_index i) {
                       // A node on the edge of the part of this rank may be
                       // another's.
                       if (space.locally_owned.is_element(i))
                         solution(i) = *value;
                       ++value;
                     });
    };
    write_solution(state.solution);
    for (auto &[name, vector] : state.histories)
      for (const auto &component : space.rest_dof)
        for (const unsigned int i : component)
          vector(rest_indices[i]) = *value++;
    for (State::Past &earlier : state.past)
      write_solution(earlier.solution);
  }
} // namespace lumbricus
