// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/nodal_history.h>
#include <lumbricus/discretization/same_cell.h>
#include <lumbricus/discretization/surface_terms.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <utility>

#include "closed_surface.h"

namespace lumbricus
{
  namespace
  {
    // The node of the cell that the point is at.
    unsigned int
    node_of(const SurfaceKernel &point)
    {
      const auto largest =
        std::max_element(std::begin(point.values), std::end(point.values));
      Assert(*largest > 1. - 1e-10, dealii::ExcInternalError());
      return largest - std::begin(point.values);
    }
  } // namespace



  SurfaceTerms::SurfaceTerms(const Body               &body,
                             const BoundaryConditions &conditions)
    : body(body)
    , conditions(conditions)
    , inside(body.space)
    , at_nodes(body.space,
               dealii::QGaussLobatto<dim - 1>(MixedSpace::degree + 1))
  {}



  void
  SurfaceTerms::set_to(const State &state)
  {
    const MixedSpace &space = body.space;
    last_time               = state.last_time;
    memories.clear();
    std::vector<dealii::types::global_dof_index> indices(
      space.rest_fe.n_dofs_per_cell());
    for_each_memory([&](const OwnedCell &cell, const auto &numbers) {
      same_cell(cell.iterator, space.rest_dof_handler)->get_dof_indices(indices);
      for (const unsigned int number : numbers)
        {
          const Vector &history = state.histories.at(history_of(number));
          AtNodes      &nodes   = memories[{number, cell.index}];
          for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
            for (unsigned int c = 0; c < dim; ++c)
              nodes[n][c] = history(indices[space.rest_dof[c][n]]);
        }
    });
  }



  bool
  SurfaceTerms::symmetric() const
  {
    if (keep_symmetry)
      return *keep_symmetry;
    keep_symmetry = true;
    std::map<std::string, std::set<dealii::types::boundary_id>> surfaces;
    for (unsigned int i = 0; i < conditions.n_conditions(); ++i)
      {
        const NamedCondition &condition = conditions.condition(i);
        const SurfaceTerm    *term      = condition.surface_term();
        if (term == nullptr || term->symmetric())
          continue;
        const std::string formula = term->uniform_pressure();
        // Two of one formula on one boundary are twice the pressure there.
        if (formula.empty() ||
            !surfaces[formula].insert(condition.boundary).second)
          keep_symmetry = false;
      }
    for (const auto &surface : surfaces)
      if (!is_closed_surface(surface.second,
                             body.space.triangulation,
                             body.anatomy.geometry(),
                             conditions))
        keep_symmetry = false;
    return *keep_symmetry;
  }



  std::set<std::string>
  SurfaceTerms::histories() const
  {
    std::set<std::string> names;
    for (unsigned int i = 0; i < conditions.n_conditions(); ++i)
      {
        const auto *term = conditions.condition(i).surface_term();
        if (term != nullptr && term->remembers())
          names.insert(history_of(i));
      }
    return names;
  }



  void
  SurfaceTerms::end_step(State &state) const
  {
    const double dt = state.time - state.last_time;
    if (histories().empty())
      return;

    const MixedSpace &space    = body.space;
    const Vector      relevant = space.with_ghosts(state.solution);
    std::vector<dealii::types::global_dof_index> indices(
      space.fe.n_dofs_per_cell()),
      rest_indices(space.rest_fe.n_dofs_per_cell());
    for_each_memory([&](const OwnedCell &owned, const auto &numbers) {
      const auto &cell = owned.iterator;
      cell->get_dof_indices(indices);
      same_cell(cell, space.rest_dof_handler)->get_dof_indices(rest_indices);
      for (const unsigned int number : numbers)
        {
          const NamedCondition &condition = conditions.condition(number);
          Vector &history = state.histories.at(history_of(number));
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
              point.X  = body.shapes.node(owned.index, n);
              point.t  = state.time;
              point.dt = dt;
              for (unsigned int c = 0; c < dim; ++c)
                {
                  point.u[c] = relevant(indices[space.displacement_dof[c][n]]);
                  point.history[c] = history(rest_indices[space.rest_dof[c][n]]);
                }
              dealii::Tensor<1, dim> changed = point.history;
              condition.surface_term()->remember(point, changed);
              for (unsigned int c = 0; c < dim; ++c)
                history(rest_indices[space.rest_dof[c][n]]) = changed[c];
            }
        }
    });
  }



  void
  SurfaceTerms::visit(const OwnedCell &owned,
                      const double (&u)[dim][ShapeCache::padded_nodes],
                      const LoadTime &t,
                      const Listener &listener)
  {
    const auto &cell = owned.iterator;
    for (const unsigned int f : cell->face_indices())
      {
        if (!cell->at_boundary(f))
          continue;
        for (const unsigned int number :
             conditions.surface_terms_on(cell->face(f)->boundary_id()))
          {
            const SurfaceTerm &term =
              *conditions.condition(number).surface_term();
            const AtNodes *memory =
              term.remembers() ? &memories.at({number, owned.index}) : nullptr;
            current = memory == nullptr ? &inside : &at_nodes;
            current->reinit(cell, f);
            for (unsigned int q = 0; q < current->n_points(); ++q)
              {
                current->set(q, u);
                SurfacePoint at{current->X,
                                current->N,
                                current->u,
                                current->F,
                                t,
                                std::max(t.to() - last_time, 0.),
                                {}};
                if (memory != nullptr)
                  at.history = (*memory)[node_of(*current)];
                SurfaceResponse response;
                term.surface(at, response);
                listener(number, response);
              }
          }
      }
  }



  const SurfaceKernel &
  SurfaceTerms::point() const
  {
    return *current;
  }



  template <typename Function>
  void
  SurfaceTerms::for_each_memory(const Function &function) const
  {
    if (histories().empty())
      return;
    for (const OwnedCell cell : body.owned_cells())
      {
        std::set<unsigned int> numbers;
        for (const auto &face : cell.iterator->face_iterators())
          if (face->at_boundary())
            for (const unsigned int number :
                 conditions.surface_terms_on(face->boundary_id()))
              if (conditions.condition(number).surface_term()->remembers())
                numbers.insert(number);
        if (!numbers.empty())
          function(cell, numbers);
      }
  }



  std::string
  SurfaceTerms::history_of(const unsigned int i) const
  {
    return NodalHistory::of_boundary(conditions.condition(i).name);
  }
} // namespace lumbricus
