// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/cell_state.h>
#include <lumbricus/discretization/same_cell.h>

namespace lumbricus
{
  CellStateAccess::CellStateAccess(const MixedSpace &space)
    : space(space)
    , indices(space.fe.n_dofs_per_cell())
    , rest_indices(space.rest_fe.n_dofs_per_cell())
  {}



  void
  CellStateAccess::read(
    const dealii::DoFHandler<dim>::active_cell_iterator &cell,
    const Vector                                        &relevant_solution,
    const State                                         &state,
    std::vector<double>                                 &values)
  {
    get_indices(cell);
    values.resize(CellState::size);
    auto value = values.begin();
    for (const auto &component : space.displacement_dof)
      for (const unsigned int i : component)
        *value++ = relevant_solution(indices[i]);
    for (const unsigned int i : space.pressure_dof)
      *value++ = relevant_solution(indices[i]);
    for (const Vector *vector :
         {&state.rest_displacement, &state.volume_displacement})
      for (const auto &component : space.rest_dof)
        for (const unsigned int i : component)
          *value++ = (*vector)(rest_indices[i]);
  }



  void
  CellStateAccess::write(
    const dealii::DoFHandler<dim>::active_cell_iterator &cell,
    const std::vector<double>                           &values,
    State                                               &state)
  {
    get_indices(cell);
    auto       value = values.begin();
    const auto set   = [&](const dealii::types::global_dof_index i) {
      // A node on the edge of the part of this rank may be another's.
      if (space.locally_owned.is_element(i))
        state.solution(i) = *value;
      ++value;
    };
    for (const auto &component : space.displacement_dof)
      for (const unsigned int i : component)
        set(indices[i]);
    for (const unsigned int i : space.pressure_dof)
      set(indices[i]);
    for (Vector *vector :
         {&state.rest_displacement, &state.volume_displacement})
      for (const auto &component : space.rest_dof)
        for (const unsigned int i : component)
          (*vector)(rest_indices[i]) = *value++;
  }



  void
  CellStateAccess::get_indices(
    const dealii::DoFHandler<dim>::active_cell_iterator &cell)
  {
    cell->get_dof_indices(indices);
    same_cell(cell, space.rest_dof_handler)->get_dof_indices(rest_indices);
  }
} // namespace lumbricus
