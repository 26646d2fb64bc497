// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/same_cell.h>

#include <deal.II/base/types.h>

#include <vector>

#include "nodal_displacement.h"

namespace lumbricus
{
  namespace
  {
    // Call function(i, k) for all components at all nodes of all cells of this rank,
    // where i is the number in a solution and k that in a history.
    template <typename Function>
    void
    for_each_entry(const MixedSpace &space, const Function &function)
    {
      std::vector<dealii::types::global_dof_index> indices(
        space.fe.n_dofs_per_cell()),
        rest_indices(space.rest_fe.n_dofs_per_cell());
      for (const auto &cell : space.owned_cells())
        {
          cell->get_dof_indices(indices);
          same_cell(cell, space.rest_dof_handler)->get_dof_indices(rest_indices);
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
              function(indices[space.displacement_dof[c][n]],
                       rest_indices[space.rest_dof[c][n]]);
        }
    }
  } // namespace



  void
  write_history(const MixedSpace &space,
                const Vector     &solution,
                Vector           &history)
  {
    const Vector relevant = space.with_ghosts(solution);
    for_each_entry(space, [&](const auto i, const auto k) {
      history(k) = relevant(i);
    });
  }



  void
  write_displacement(const MixedSpace &space,
                     const Vector     &history,
                     Vector           &solution)
  {
    for_each_entry(space, [&](const auto i, const auto k) {
      // A node on the edge of the part of this rank may be another's.
      if (space.locally_owned.is_element(i))
        solution(i) = history(k);
    });
  }
} // namespace lumbricus
