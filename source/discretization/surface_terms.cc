// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/nodal_history.h>
#include <lumbricus/discretization/element_kernel.h>
#include <lumbricus/discretization/same_cell.h>
#include <lumbricus/discretization/surface_terms.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <utility>

#include "closed_surface.h"
#include "remembering_cells.h"

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
    const auto remember = [&](const OwnedCell &cell, const auto &numbers) {
      same_cell(cell.iterator, space.rest_dof_handler)->get_dof_indices(indices);
      for (const unsigned int number : numbers)
        {
          const Vector &history = state.histories.at(history_of(number));
          AtNodes      &nodes   = memories[{number, cell.index}];
          for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
            for (unsigned int c = 0; c < dim; ++c)
              nodes[n][c] = history(indices[space.rest_dof[c][n]]);
        }
    };
    for_each_remembering_cell(body, conditions, remember);
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



  bool
  SurfaceTerms::may_slide() const
  {
    for (unsigned int i = 0; i < conditions.n_conditions(); ++i)
      {
        const auto *term = conditions.condition(i).surface_term();
        if (term != nullptr && term->may_slide())
          return true;
      }
    return false;
  }



  double
  SurfaceTerms::part_of_slide(const Vector   &solution,
                              const Vector   &dx,
                              const LoadTime &t,
                              const double    most)
  {
    // What moves, once for all lengths of the step.
    struct Moving
    {
      const SurfaceTerm     *term;
      SurfacePoint           point;
      dealii::Tensor<1, dim> du;
      double                 JxW;
    };
    std::vector<Moving> all;
    const MixedSpace   &space    = body.space;
    const Vector        relevant = space.with_ghosts(solution);
    const Vector        change   = space.with_ghosts(dx);
    ElementKernel       there, moving;
    std::vector<dealii::types::global_dof_index> indices(
      space.fe.n_dofs_per_cell());
    const auto collect = [&](const OwnedCell &cell, const auto & /*numbers*/) {
      there.read(space, cell.iterator, relevant, indices);
      moving.read(space, cell.iterator, change, indices);
      for_each_point(cell,
                     there.u,
                     t,
                     [&](const unsigned int /*number*/,
                         const SurfaceTerm  &term,
                         const SurfacePoint &at) {
                       if (!term.may_slide())
                         return;
                       const auto du = moving.displacement(point().values);
                       all.push_back({&term, at, du, point().JxW});
                     });
    };
    for_each_remembering_cell(body, conditions, collect);

    const auto pull_back = [&](const double part) {
      double sum = 0.;
      for (const Moving &one : all)
        sum += one.JxW * one.term->pull_back(one.point, part * one.du) / part;
      return dealii::Utilities::MPI::sum(sum, space.communicator());
    };
    constexpr unsigned int n_halvings = 20;
    constexpr double       near       = 0.9;
    double                 low = 0., high = 1.;
    if (pull_back(high) <= most)
      return 1.;
    for (unsigned int i = 0; i < n_halvings && low < near * high; ++i)
      {
        const double middle = 0.5 * (low + high);
        (pull_back(middle) <= most ? low : high) = middle;
      }
    return high;
  }



  void
  SurfaceTerms::visit(const OwnedCell &cell,
                      const double (&u)[dim][ShapeCache::padded_nodes],
                      const LoadTime &t,
                      const Listener &listener)
  {
    for_each_point(cell,
                   u,
                   t,
                   [&](const unsigned int  number,
                       const SurfaceTerm  &term,
                       const SurfacePoint &at) {
                     SurfaceResponse response;
                     term.surface(at, response);
                     listener(number, response);
                   });
  }



  void
  SurfaceTerms::visit_points(const OwnedCell &cell,
                             const double (&u)[dim][ShapeCache::padded_nodes],
                             const LoadTime      &t,
                             const PointListener &listener)
  {
    for_each_point(cell,
                   u,
                   t,
                   [&](const unsigned int number,
                       const SurfaceTerm & /*term*/,
                       const SurfacePoint &at) { listener(number, at); });
  }



  void
  SurfaceTerms::visit_points(const Vector        &solution,
                             const LoadTime      &t,
                             const PointListener &listener)
  {
    const Vector  relevant = body.space.with_ghosts(solution);
    ElementKernel kernel;
    std::vector<dealii::types::global_dof_index> indices(
      body.space.fe.n_dofs_per_cell());
    for (const OwnedCell cell : body.owned_cells())
      if (cell.iterator->at_boundary())
        {
          kernel.read(body.space, cell.iterator, relevant, indices);
          visit_points(cell, kernel.u, t, listener);
        }
  }



  template <typename Function>
  void
  SurfaceTerms::for_each_point(const OwnedCell &owned,
                               const double (&u)[dim][ShapeCache::padded_nodes],
                               const LoadTime &t,
                               const Function &function)
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
                at.segment = owned.region.segment;
                if (memory != nullptr)
                  at.history = (*memory)[node_of(*current)];
                function(number, term, at);
              }
          }
      }
  }



  const SurfaceKernel &
  SurfaceTerms::point() const
  {
    return *current;
  }



  std::string
  SurfaceTerms::history_of(const unsigned int i) const
  {
    return NodalHistory::of_boundary(conditions.condition(i).name);
  }
} // namespace lumbricus
