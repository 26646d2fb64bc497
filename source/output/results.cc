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
    newton              = report.newton;
  }



  Results::Results(const RunFolder                       &folder,
                   const MixedSpace                      &space,
                   const ShapeCache                      &shapes,
                   const Anatomy                         &anatomy,
                   const ReferenceField                  &references,
                   const std::vector<dealii::Point<dim>> &probe_points,
                   const unsigned int                     vtu_every)
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
    , newton(folder,
             "newton.csv",
             {"step",
              "solve",
              "iteration",
              "force_residual",
              "volume_residual",
              "increment",
              "step_length"},
             space.communicator())
    , cell_fields(space, shapes, anatomy, references)
    , vtu(folder, space, anatomy)
    , probes(probe_points, folder, space, cell_fields)
  {
    cell_fields.reinit();
  }



  void
  Results::write(const State &state, const StepRecord &step)
  {
    write_segments(state, step);
    write_steps(step);

    const bool with_vtu = vtu_every > 0 && step.number % vtu_every == 0;
    if (with_vtu || !probes.empty())
      cell_fields.update(state.solution);
    probes.write(state);
    if (with_vtu)
      vtu.write(state, cell_fields);
    vtu_is_current = with_vtu;
  }



  void
  Results::write_last(const State &state)
  {
    if (vtu_is_current)
      return;
    cell_fields.update(state.solution);
    vtu.write(state, cell_fields);
    vtu_is_current = true;
  }



  void
  Results::write_segments(const State &state, const StepRecord &step)
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
  }



  void
  Results::write_steps(const StepRecord &step)
  {
    steps << step.number << step.time << step.size << step.n_cuts
          << step.n_solves << step.n_newton_iterations
          << step.n_linear_iterations << step.n_factorisations << step.seconds
          << step.elapsed_seconds;
    steps.end_row();
    steps.flush();

    for (unsigned int solve = 0; solve < step.newton.size(); ++solve)
      for (unsigned int k = 0; k < step.newton[solve].size(); ++k)
        {
          const NewtonIteration &iteration = step.newton[solve][k];
          newton << step.number << solve + 1 << k + 1
                 << iteration.residual.force << iteration.residual.volume
                 << iteration.increment << iteration.step_length;
          newton.end_row();
        }
    newton.flush();
  }
} // namespace lumbricus
