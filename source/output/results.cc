// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/section_measures.h>
#include <lumbricus/output/results.h>

namespace lumbricus
{
  namespace
  {
    // The columns that segments.csv and resets.csv share.
    void
    add_segment(CsvTable                    &table,
                const ResetIteration::Solve &solve,
                const unsigned int           s)
    {
      table << solve.measures[s].length << solve.measures[s].mid_radius
            << solve.segments[s].liquid_volume << solve.segments[s].wall_volume
            << solve.segments[s].mean_pressure() << solve.divergence[s];
    }
  } // namespace



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
    , resets(folder,
             "resets.csv",
             {"t",
              "reset",
              "segment",
              "length",
              "mid_radius",
              "fluid_volume",
              "wall_volume",
              "fluid_pressure",
              "eta",
              "largest_deviator"},
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
    if (step.report.solves.empty())
      write_segments(state.time, at_rest(state));
    else
      write_segments(state.time, step.report);
    write_resets(state.time, step.report);
    write_steps(step);
    write_newton(step);

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
  Results::note(RunProgress &progress) const
  {
    for (const CsvTable *table :
         {&segments, &resets, &steps, &newton, probes.csv_table()})
      if (table != nullptr)
        progress.table_sizes.insert(table->name_and_size());
    progress.vtu_files      = vtu.files();
    progress.vtu_is_current = vtu_is_current;
  }



  void
  Results::continue_after(const RunProgress &progress)
  {
    vtu.continue_after(progress.vtu_files);
    vtu_is_current = progress.vtu_is_current;
  }



  ResetIteration::Report
  Results::at_rest(const State &state) const
  {
    ResetIteration::Solve solve;
    solve.segments =
      segment_states(space, shapes, anatomy, references, state.solution);
    solve.measures = section_measures(space, anatomy, state.solution);
    solve.divergence.assign(solve.segments.size(), 0.);

    ResetIteration::Report report;
    report.n_resets.assign(solve.segments.size(), 0);
    report.solves.push_back(solve);
    return report;
  }



  void
  Results::write_segments(const double t, const ResetIteration::Report &report)
  {
    const ResetIteration::Solve &solve = report.solves.back();
    for (unsigned int s = 0; s < solve.segments.size(); ++s)
      {
        segments << t << s + 1;
        add_segment(segments, solve, s);
        segments << report.n_resets[s];
        segments.end_row();
      }
    segments.flush();
  }



  void
  Results::write_resets(const double t, const ResetIteration::Report &report)
  {
    for (unsigned int k = 0; k < report.solves.size(); ++k)
      for (unsigned int s = 0; s < report.solves[k].segments.size(); ++s)
        {
          resets << t << k << s + 1;
          add_segment(resets, report.solves[k], s);
          resets << report.solves[k].segments[s].largest_deviator;
          resets.end_row();
        }
    resets.flush();
  }



  void
  Results::write_steps(const StepRecord &step)
  {
    steps << step.number << step.time << step.size << step.n_cuts
          << step.report.solves.size() << step.report.n_newton_iterations()
          << step.n_linear_iterations << step.n_factorisations << step.seconds
          << step.elapsed_seconds;
    steps.end_row();
    steps.flush();
  }



  void
  Results::write_newton(const StepRecord &step)
  {
    for (unsigned int k = 0; k < step.report.solves.size(); ++k)
      {
        unsigned int n = 0;
        for (const NewtonIteration &iteration : step.report.solves[k].newton)
          {
            newton << step.number << k + 1 << ++n << iteration.residual.force
                   << iteration.residual.volume << iteration.increment
                   << iteration.step_length;
            newton.end_row();
          }
      }
    newton.flush();
  }
} // namespace lumbricus
