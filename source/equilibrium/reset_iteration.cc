// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/discretization/same_cell.h>
#include <lumbricus/equilibrium/reset_iteration.h>
#include <lumbricus/parameters/patterns.h>

#include <algorithm>
#include <sstream>

#include "enclosed_liquid.h"

namespace lumbricus
{
  namespace
  {
    // Lets the liquid flow as long as it lives.
    class Flow
    {
    public:
      Flow(ReferenceField &references, const bool flows)
        : references(references)
        , flows(flows)
      {
        if (flows)
          references.let_liquid_flow(true);
      }

      ~Flow()
      {
        if (flows)
          references.let_liquid_flow(false);
      }

    private:
      ReferenceField &references;
      const bool      flows;
    };
  } // namespace



  void
  ResetIteration::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Reset");
    prm.add_parameter("Every",
                      every,
                      "When the liquid is reset. 'iteration': its shape is the "
                      "stress-free one in every iteration of Newton's method, "
                      "so that one solve finds the hydrostatic state. 'solve': "
                      "after a solve that is not hydrostatic, as in the paper. "
                      "So it is in any case in mode 'full', with Least, where "
                      "the mesh in the liquid is never relaxed, where liquid "
                      "slips or is on the surface of the body, and with laws "
                      "that are not isochoric or have fibres.",
                      dealii::Patterns::Selection("iteration|solve"));
    prm.add_parameter("Mode",
                      mode,
                      "What a reset of the liquid forgets. 'isochoric': its "
                      "shape. 'full': its shape and its volume change, as in "
                      "the paper, so that for nu < 0.5 volume is lost.",
                      dealii::Patterns::Selection("isochoric|full"));
    prm.add_parameter("Tolerance",
                      tolerance,
                      "[-] A segment is hydrostatic when int |dev sigma| dv is "
                      "at most this times int |p| dv over its liquid.",
                      PositiveNumber());
    prm.add_parameter("Least",
                      least,
                      "[-] Fewest resets in one load step, hydrostatic or not: "
                      "for the paper's fixed number of iterations.",
                      dealii::Patterns::Integer(0));
    prm.add_parameter("Limit",
                      limit,
                      "[-] Most resets in one load step; 0 for none at all, "
                      "whatever the divergence.",
                      dealii::Patterns::Integer(0));
    prm.add_parameter("Pressure floor",
                      pressure_floor,
                      "[N/mm^2] Where the mean of |p| is less than this, this "
                      "takes its place in the divergence.",
                      PositiveNumber());
    prm.leave_subsection();
    liquid_mesh.declare_parameters(prm);
  }



  ResetIteration
  ResetIteration::with_least(const unsigned int n) const
  {
    ResetIteration other = *this;
    other.least          = n;
    return other;
  }



  unsigned int
  ResetIteration::Report::n_newton_iterations() const
  {
    unsigned int n = 0;
    for (const Solve &solve : solves)
      n += solve.newton.size();
    return n;
  }



  void
  ResetIteration::report_to(const Listener &new_listener)
  {
    listener = new_listener;
  }



  LiquidMesh::Relaxation
  ResetIteration::relax_mesh(State &state, const Model &model) const
  {
    if (limit == 0 || lets_flow(model))
      return {};
    return liquid_mesh.relax(model.body, model.unknowns, state);
  }



  ResetIteration::Report
  ResetIteration::solve(State        &state,
                        const Vector &guess,
                        const Model  &model) const
  {
    const Body        &body       = model.body;
    const unsigned int n_segments = body.anatomy.geometry().n_segments();
    Report             report;
    report.n_resets.assign(n_segments, 0);

    const bool             flows              = lets_flow(model);
    constexpr unsigned int most_augmentations = 100;
    unsigned int           n_augmentations    = 0;
    Unknowns               x{guess, state.globals};
    for (unsigned int n_resets = 0;; ++n_resets)
      {
        Solve solve;
        model.equilibrium.start_from(state.solution);
        {
          const Flow flow(model.references, flows);
          solve.newton = model.newton.solve(model.equilibrium, x);
        }
        state.solution = x.solution;
        state.globals  = x.globals;
        if (flows)
          {
            reset(state, std::vector<bool>(n_segments, true), body);
            model.references.update_liquid(state);
          }
        measure(state, model, solve);
        report.solves.push_back(solve);

        std::vector<bool> diverges;
        for (const double divergence : solve.divergence)
          diverges.push_back(divergence > tolerance);
        const bool hydrostatic = std::none_of(diverges.begin(),
                                              diverges.end(),
                                              [](const bool d) { return d; });
        const bool done =
          limit == 0 || flows || (hydrostatic && n_resets >= least);
        Vector     way;
        const bool is_augmented =
          !model.surface.augment(state, model.equilibrium.load_time(), way);
        if (!done && n_resets >= least)
          check_progress(report.solves, diverges);
        const std::vector<bool> is_reset =
          flows             ? segments_with_liquid(body) :
          done              ? std::vector<bool>(n_segments, false) :
          n_resets >= least ? diverges :
                              std::vector<bool>(n_segments, true);
        if (listener)
          listener(solve, is_reset);
        for (unsigned int s = 0; s < n_segments; ++s)
          report.n_resets[s] += is_reset[s];
        if (done && is_augmented)
          {
            if (flows)
              settle(state, model, report);
            return report;
          }
        AssertThrow(is_augmented || ++n_augmentations < most_augmentations,
                    ExcNotConverged(
                      "The skin goes into an obstacle by more than its "
                      "'Penetration' after " +
                      std::to_string(most_augmentations) +
                      " augmentations. Raise its 'Stiffness' or "
                      "'Penetration'"));

        reset(state, is_reset, body);
        if (!is_augmented)
          {
            model.surface.set_to(state);
            model.equilibrium.constrain(way);
            x.solution += way;
          }
        model.references.update_liquid(state);
      }
  }



  bool
  ResetIteration::lets_flow(const Model &model) const
  {
    return every == "iteration" && mode == "isochoric" && least == 0 &&
           limit > 0 && liquid_mesh.relaxes() && !model.slips &&
           model.body.anatomy.liquids_may_flow() &&
           has_enclosed_liquid(model.body);
  }



  void
  ResetIteration::measure(const State &state,
                          const Model &model,
                          Solve       &solve) const
  {
    dealii::TimerOutput::Scope scope(model.timer, "reset");
    const Vector relevant = model.body.space.with_ghosts(state.solution);
    solve.segments =
      segment_states(model.body, model.references, relevant, state.globals);
    const auto excess = model.weight.mean_excess(relevant);
    for (unsigned int s = 0; s < solve.segments.size(); ++s)
      solve.segments[s].pressure += excess[s] * solve.segments[s].liquid_volume;
    solve.measures  = section_measures(model.body, relevant);
    solve.qualities = mesh_qualities(model.body, &relevant);
    solve.divergence.clear();
    for (const SegmentState &segment : solve.segments)
      solve.divergence.push_back(segment.divergence(pressure_floor));
  }



  void
  ResetIteration::settle(State       &state,
                         const Model &model,
                         Report      &report) const
  {
    {
      dealii::TimerOutput::Scope scope(model.timer, "liquid's mesh");
      report.relaxed =
        liquid_mesh.settle(model.body, model.unknowns, state).in_segment;
    }
    if (report.relaxed.empty())
      return;
    model.references.update_liquid(state);
    measure(state, model, report.solves.back());
  }



  void
  ResetIteration::check_progress(const std::vector<Solve> &solves,
                                 const std::vector<bool>  &diverges) const
  {
    const unsigned int n_resets = solves.size() - 1;
    const auto         grows    = [&](const unsigned int s) {
      double least_so_far = solves[0].divergence[s];
      for (const Solve &solve : solves)
        least_so_far = std::min(least_so_far, solve.divergence[s]);
      return n_resets > 3 && solves.back().divergence[s] > 10. * least_so_far;
    };

    std::ostringstream segments;
    bool               some_grow = false;
    for (unsigned int s = 0; s < diverges.size(); ++s)
      if (diverges[s])
        {
          segments << " segment " << s + 1 << " (divergence "
                   << solves.back().divergence[s] << ")";
          some_grow = some_grow || grows(s);
        }
    AssertThrow(!some_grow,
                ExcNotConverged("The liquid moves away from the hydrostatic "
                                "state after " +
                                std::to_string(n_resets) +
                                " resets:" + segments.str() +
                                ". Raise 'Reset/Tolerance', or choose another "
                                "'Interface/Coupling'"));
    AssertThrow(n_resets < limit,
                ExcNotConverged("The liquid is not hydrostatic after " +
                                std::to_string(limit) +
                                " resets:" + segments.str() +
                                ". Soften the liquid, or raise 'Reset/Limit' "
                                "or 'Reset/Tolerance'"));
  }



  void
  ResetIteration::reset(State                   &state,
                        const std::vector<bool> &in_segment,
                        const Body              &body) const
  {
    const MixedSpace &space          = body.space;
    const Vector      relevant       = space.with_ghosts(state.solution);
    const bool        volume_too     = forgets_volume();
    Vector           &u_ref          = rest_displacement.in(state);
    Vector           &u_vol          = volume_displacement.in(state);
    std::vector<dealii::types::global_dof_index> indices(
      space.fe.n_dofs_per_cell());
    std::vector<dealii::types::global_dof_index> rest_indices(
      space.rest_fe.n_dofs_per_cell());
    for (const OwnedCell cell : body.owned_cells())
      {
        if (!cell.is_liquid || !in_segment[cell.region.segment])
          continue;
        cell.iterator->get_dof_indices(indices);
        same_cell(cell.iterator, space.rest_dof_handler)
          ->get_dof_indices(rest_indices);
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
            {
              const double u = relevant(indices[space.displacement_dof[c][n]]);
              const auto   index = rest_indices[space.rest_dof[c][n]];
              u_ref(index)       = u;
              if (volume_too)
                u_vol(index) = u;
            }
      }
  }
} // namespace lumbricus
