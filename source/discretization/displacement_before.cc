// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/displacement_before.h>
#include <lumbricus/discretization/same_cell.h>

#include <deal.II/base/types.h>

#include <vector>

namespace lumbricus
{
  const NodalHistory displacement_before{"u_before", NodalHistory::Runs::some};



  bool
  muscles_feel_speed(const Anatomy &anatomy)
  {
    for (unsigned int i = 0; i < anatomy.n_muscles(); ++i)
      if (anatomy.muscle(i).action().feels_speed())
        return true;
    return false;
  }



  bool
  way_counts(const Anatomy &anatomy)
  {
    return muscles_feel_speed(anatomy) || anatomy.n_viscous_branches() > 0;
  }



  void
  remember_displacement(const Body &body, State &state)
  {
    if (!way_counts(body.anatomy))
      return;
    const MixedSpace &space    = body.space;
    const Vector      relevant = space.with_ghosts(state.solution);
    Vector           &u        = displacement_before.in(state);
    std::vector<dealii::types::global_dof_index> indices(
      space.fe.n_dofs_per_cell()),
      rest_indices(space.rest_fe.n_dofs_per_cell());
    for (const OwnedCell cell : body.owned_cells())
      {
        cell.iterator->get_dof_indices(indices);
        same_cell(cell.iterator, space.rest_dof_handler)
          ->get_dof_indices(rest_indices);
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
            u[rest_indices[space.rest_dof[c][n]]] =
              relevant(indices[space.displacement_dof[c][n]]);
      }
  }
} // namespace lumbricus
