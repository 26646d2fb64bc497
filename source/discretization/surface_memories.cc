// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/same_cell.h>
#include <lumbricus/discretization/surface_terms.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <type_traits>

#include "remembering_cells.h"

namespace lumbricus
{
  template <typename StateType, typename Function>
  void
  SurfaceTerms::for_each_node(StateType      &state,
                              const Vector   &solution,
                              const LoadTime &t,
                              const Function &function) const
  {
    if (histories().empty())
      return;

    const MixedSpace &space    = body.space;
    const Vector      relevant = space.with_ghosts(solution);
    std::vector<dealii::types::global_dof_index> indices(
      space.fe.n_dofs_per_cell()),
      rest_indices(space.rest_fe.n_dofs_per_cell());
    const auto visit_cell = [&](const OwnedCell &owned, const auto &numbers) {
      const auto &cell = owned.iterator;
      cell->get_dof_indices(indices);
      same_cell(cell, space.rest_dof_handler)->get_dof_indices(rest_indices);
      for (const unsigned int number : numbers)
        {
          const NamedCondition &condition = conditions.condition(number);
          auto &remembered = state.histories.at(history_of(number));
          for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
            {
              const auto is_on = [&](const unsigned int f) {
                return cell->at_boundary(f) &&
                       cell->face(f)->boundary_id() == condition.boundary &&
                       space.fe.has_support_on_face(
                         space.displacement_dof[0][n], f);
              };
              const auto faces = cell->face_indices();
              if (std::none_of(faces.begin(), faces.end(), is_on))
                continue;
              SurfacePoint point;
              point.X       = body.shapes.node(owned.index, n);
              point.t       = t;
              point.dt      = std::max(t.to() - state.last_time, 0.);
              point.segment = owned.region.segment;
              for (unsigned int c = 0; c < dim; ++c)
                {
                  point.u[c] = relevant(indices[space.displacement_dof[c][n]]);
                  point.history[c] =
                    remembered(rest_indices[space.rest_dof[c][n]]);
                }
              dealii::Tensor<1, dim> history = point.history;
              function(owned, n, number, point, history);
              if constexpr (!std::is_const_v<StateType>)
                for (unsigned int c = 0; c < dim; ++c)
                  remembered(rest_indices[space.rest_dof[c][n]]) = history[c];
            }
        }
    };
    for_each_remembering_cell(body, conditions, visit_cell);
  }



  void
  SurfaceTerms::end_step(State &state) const
  {
    for_each_node(state,
                  state.solution,
                  state.time,
                  [&](const OwnedCell & /*cell*/,
                      const unsigned int /*node*/,
                      const unsigned int      number,
                      const SurfacePoint     &point,
                      dealii::Tensor<1, dim> &history) {
                    conditions.condition(number).surface_term()->remember(
                      point, history);
                  });
  }



  bool
  SurfaceTerms::augment(State &state, const LoadTime &t, Vector &way) const
  {
    // A node has cells on several ranks, which all say the same.
    const MixedSpace &space = body.space;
    Vector sum(space.locally_owned, space.locally_relevant, space.communicator());
    Vector n_cells = sum;
    bool   any     = false;
    std::vector<dealii::types::global_dof_index> indices(
      space.fe.n_dofs_per_cell());
    for_each_node(state,
                  state.solution,
                  t,
                  [&](const OwnedCell        &cell,
                      const unsigned int      node,
                      const unsigned int      number,
                      const SurfacePoint     &point,
                      dealii::Tensor<1, dim> &history) {
                    const SurfaceTerm &term =
                      *conditions.condition(number).surface_term();
                    if (term.is_augmented(point))
                      return;
                    any              = true;
                    const auto moved = term.augment(point, history);
                    cell.iterator->get_dof_indices(indices);
                    for (unsigned int c = 0; c < dim; ++c)
                      {
                        const auto index =
                          indices[space.displacement_dof[c][node]];
                        sum(index) += moved[c];
                        n_cells(index) += 1.;
                      }
                  });
    if (!dealii::Utilities::MPI::logical_or(any, space.communicator()))
      return false;
    sum.compress(dealii::VectorOperation::add);
    n_cells.compress(dealii::VectorOperation::add);
    way.reinit(state.solution);
    for (unsigned int k = 0; k < way.locally_owned_size(); ++k)
      if (n_cells.local_element(k) > 0.)
        way.local_element(k) = sum.local_element(k) / n_cells.local_element(k);
    return true;
  }



  void
  SurfaceTerms::visit_cell_nodes(const State            &state,
                                 const CellNodeListener &listener) const
  {
    for_each_node(state,
                  state.solution,
                  state.time,
                  [&](const OwnedCell    &cell,
                      const unsigned int  node,
                      const unsigned int  number,
                      const SurfacePoint &point,
                      const dealii::Tensor<1, dim> & /*history*/) {
                    listener(cell, node, number, point);
                  });
  }
} // namespace lumbricus
