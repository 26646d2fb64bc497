// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/output/results.h>
#include <lumbricus/output/section_measures.h>

namespace lumbricus
{
  StepRecord::StepRecord(const unsigned int n_segments)
    : n_resets(n_segments, 0)
    , divergence(n_segments, 0.)
  {}



  void
  StepRecord::take(const ResetIteration::Report &report)
  {
    n_solves            = report.newton.size();
    n_newton_iterations = report.n_newton_iterations();
    n_resets            = report.n_resets;
    divergence          = report.divergence;
  }



  Results::Results(const RunFolder      &folder,
                   const MixedSpace     &space,
                   const ShapeCache     &shapes,
                   const Anatomy        &anatomy,
                   const ReferenceField &references,
                   const unsigned int    vtu_every)
    : space(space)
    , shapes(shapes)
    , anatomy(anatomy)
    , references(references)
    , vtu_every(vtu_every)
    , segments(folder,
               "segments.csv",
               {"t",
                "segment",
                "length",
                "mid_radius",
                "fluid_volume",
                "wall_volume",
                "fluid_pressure",
                "eta",
                "resets"},
               space.communicator())
    , steps(folder,
            "steps.csv",
            {"step",
             "t",
             "dt",
             "cuts",
             "solves",
             "newton_iterations",
             "linear_iterations",
             "factorisations",
             "seconds",
             "elapsed_seconds"},
            space.communicator())
    , vtu(folder, space, anatomy)
    , cell_fields(space, shapes, anatomy, references)
  {
    cell_fields.reinit();
  }



  void
  Results::write(const State &state, const StepRecord &step)
  {
    const auto states =
      segment_states(space, shapes, anatomy, references, state.solution);
    const auto measures = section_measures(space, anatomy, state.solution);
    for (unsigned int s = 0; s < states.size(); ++s)
      {
        segments << state.time << s + 1 << measures[s].length
                 << measures[s].mid_radius << states[s].liquid_volume
                 << states[s].wall_volume << states[s].mean_pressure()
                 << step.divergence[s] << step.n_resets[s];
        segments.end_row();
      }
    segments.flush();

    steps << step.number << step.time << step.size << step.n_cuts
          << step.n_solves << step.n_newton_iterations
          << step.n_linear_iterations << step.n_factorisations << step.seconds
          << step.elapsed_seconds;
    steps.end_row();
    steps.flush();

    vtu_is_current = false;
    if (vtu_every > 0 && step.number % vtu_every == 0)
      write_last(state);
  }



  void
  Results::write_last(const State &state)
  {
    if (!vtu_is_current)
      vtu.write(state, cell_fields);
    vtu_is_current = true;
  }
} // namespace lumbricus
