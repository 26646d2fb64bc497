// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/cell_sizes.h>
#include <lumbricus/discretization/displacement_before.h>
#include <lumbricus/discretization/element_kernel.h>
#include <lumbricus/discretization/reference_field.h>
#include <lumbricus/discretization/viscous_memory.h>

#include <algorithm>
#include <vector>

namespace lumbricus
{
  namespace
  {
    using cell_sizes::n_q;

    // Call function(cell) for all owned cells; an ExcInput on one rank is
    // thrown on all.
    template <typename Function>
    void
    for_each_cell(const Body &body, const Function &function)
    {
      std::string message;
      try
        {
          for (const OwnedCell cell : body.owned_cells())
            function(cell);
        }
      catch (const ExcInput &exception)
        {
          message = plain_message(exception);
        }
      throw_on_all_ranks<ExcInput>(message, body.space.communicator());
    }
  } // namespace



  ReferenceField::ReferenceField(const Body &body)
    : body(body)
  {}



  void
  ReferenceField::reinit()
  {
    points.assign(body.shapes.n_owned_cells() * n_q, MaterialPoint());

    for_each_cell(body, [&](const OwnedCell &cell) {
      for (unsigned int q = 0; q < n_q; ++q)
        {
          const auto    &X     = body.shapes.quadrature_point(cell.index, q);
          MaterialPoint &point = points[cell.index * n_q + q];
          for (const Muscle *muscle : cell.tissue.muscles())
            point.fibres.push_back(
              muscle->fibre_at_rest(cell.region.segment + 1, X));
          point.elastic_fibres = cell.tissue.elastic_fibres(X);
          point.viscous.resize(cell.tissue.viscous_branches().size());
          point.reference =
            cell.tissue.reference_map(point.fibres, point.elastic_fibres);
        }
    });
  }



  void
  ReferenceField::update_muscles(const LoadTime &t)
  {
    for_each_cell(body, [&](const OwnedCell &cell) {
      const auto &muscles = cell.tissue.muscles();
      if (muscles.empty())
        return;
      for (unsigned int q = 0; q < n_q; ++q)
        {
          MaterialPoint &point = points[cell.index * n_q + q];
          for (unsigned int k = 0; k < muscles.size(); ++k)
            {
              point.fibres[k].activation =
                muscles[k]->activation(t,
                                       cell.region.segment + 1,
                                       body.shapes.quadrature_point(cell.index,
                                                                    q));
              point.fibres[k].since = 0.;
            }
          point.reference =
            cell.tissue.reference_map(point.fibres, point.elastic_fibres);
        }
    });
  }



  void
  ReferenceField::update_speed(const State &state, const LoadTime &t)
  {
    const double since = std::max(t.to() - state.last_time, 0.);
    if (since == 0. || !muscles_feel_speed(body.anatomy))
      return;
    const Vector                                &u = displacement_before.in(state);
    ElementKernel                                before;
    std::vector<dealii::types::global_dof_index> indices(
      body.space.rest_fe.n_dofs_per_cell());
    for (const OwnedCell cell : body.owned_cells())
      {
        const auto &muscles = cell.tissue.muscles();
        if (muscles.empty())
          continue;
        before.read_history(body.space, cell.iterator, u, indices);
        before.compute_deformation(body.shapes.cell(cell.index));
        for (unsigned int q = 0; q < n_q; ++q)
          for (unsigned int k = 0; k < muscles.size(); ++k)
            if (muscles[k]->action().feels_speed())
              {
                MuscleFibre &fibre   = points[cell.index * n_q + q].fibres[k];
                fibre.stretch_before = (before.F[q] * fibre.f).norm();
                fibre.since          = since;
              }
      }
  }



  void
  ReferenceField::update_branches(const State &state, const LoadTime &t)
  {
    if (body.anatomy.n_viscous_branches() == 0)
      return;
    ViscousMemory memory(body, state, t.to());
    for (const OwnedCell cell : body.owned_cells())
      if (cell.tissue.viscous_branches().size() > 0)
        memory.read(cell, points.data() + cell.index * n_q);
  }



  void
  ReferenceField::update_liquid(const State &state)
  {
    const Vector &u_ref = rest_displacement.in(state);
    const Vector &u_vol = volume_displacement.in(state);
    ElementKernel                                rest, volume;
    const MixedSpace                            &space = body.space;
    std::vector<dealii::types::global_dof_index> indices(
      space.rest_fe.n_dofs_per_cell());
    for (const OwnedCell cell : body.owned_cells())
      {
        if (!cell.is_liquid)
          continue;
        rest.read_history(space, cell.iterator, u_ref, indices);
        volume.read_history(space, cell.iterator, u_vol, indices);
        const ShapeCache::Cell shape = body.shapes.cell(cell.index);
        rest.compute_deformation(shape);
        volume.compute_deformation(shape);
        for (unsigned int q = 0; q < n_q; ++q)
          points[cell.index * n_q + q].reference =
            rest_shape_map(rest.F[q], volume.F[q]);
      }
  }



  void
  ReferenceField::let_liquid_flow(const bool flows)
  {
    for (const OwnedCell cell : body.owned_cells())
      if (cell.is_liquid)
        for (unsigned int q = 0; q < n_q; ++q)
          points[cell.index * n_q + q].reference.flows = flows;
  }



  void
  ReferenceField::update(const State &state, const LoadTime &t)
  {
    update_muscles(t);
    update_speed(state, t);
    update_branches(state, t);
    update_liquid(state);
  }



  void
  ReferenceField::update(const State &state)
  {
    update(state, state.time);
  }



  const MaterialPoint *
  ReferenceField::cell(const unsigned int owned_index) const
  {
    return points.data() + owned_index * n_q;
  }
} // namespace lumbricus
