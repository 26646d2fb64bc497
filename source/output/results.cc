// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/section_measures.h>
#include <lumbricus/output/results.h>

#include <algorithm>

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



  Results::Results(RunFolder                             &folder,
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
                "resets",
                "fluid_mesh_quality",
                "wall_mesh_quality",
                "relaxed"},
               space.communicator())
    , resets(folder,
             "resets.csv",
             {"t",
              "cycle",
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
    , reactions(folder,
                "reactions.csv",
                {"t",
                 "kind",
                 "name",
                 "force_x",
                 "force_y",
                 "force_z",
                 "moment_x",
                 "moment_y",
                 "moment_z"},
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
             "softest_stiffness",
             "seconds",
             "elapsed_seconds"},
            space.communicator())
    , newton(folder,
             "newton.csv",
             {"step",
              "cycle",
              "solve",
              "iteration",
              "force_residual",
              "volume_residual",
              "increment",
              "step_length"},
             space.communicator())
    , mesh(folder,
           "mesh.csv",
           {"step",
            "t",
            "cycle",
            "cells",
            "unknowns",
            "refined",
            "coarsened",
            "converged",
            "estimated_error",
            "volume_change",
            "pressure_change",
            "newton_iterations",
            "resets"},
           space.communicator())
    , cell_fields(space, shapes, anatomy, references)
    , vtu(folder, space, anatomy)
    , probes(probe_points, folder, space, cell_fields)
  {
    cell_fields.reinit();
  }



  void
  Results::reinit()
  {
    cell_fields.reinit();
    probes.reinit();
  }



  void
  Results::write(const State &state, const StepRecord &step)
  {
    write_segments(state, step);
    write_resets(step);
    write_reactions(step);
    write_steps(step);
    write_newton(step);
    write_mesh(step);

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
    for (const CsvTable *table : {&segments,
                                  &resets,
                                  &reactions,
                                  &steps,
                                  &newton,
                                  &mesh,
                                  probes.csv_table()})
      if (table != nullptr)
        progress.tables.insert(table->name_and_content());
    progress.vtu_files      = vtu.files();
    progress.vtu_is_current = vtu_is_current;
  }



  void
  Results::continue_after(const RunProgress &progress)
  {
    vtu.continue_after(progress.vtu_files);
    vtu_is_current = progress.vtu_is_current;
  }



  ResetIteration::Solve
  Results::at_rest(const State &state) const
  {
    const Vector          relevant = space.with_ghosts(state.solution);
    ResetIteration::Solve solve;
    solve.segments =
      segment_states(space, shapes, anatomy, references, relevant);
    solve.measures  = section_measures(space, anatomy, relevant);
    solve.qualities = mesh_qualities(space, shapes, anatomy, &relevant);
    solve.divergence.assign(solve.segments.size(), 0.);
    return solve;
  }



  void
  Results::write_segments(const State &state, const StepRecord &step)
  {
    const auto                  reports = step.reports();
    const ResetIteration::Solve solve   = reports.back()->solves.empty() ?
                                            at_rest(state) :
                                            reports.back()->solves.back();
    for (unsigned int s = 0; s < solve.segments.size(); ++s)
      {
        unsigned int n_resets = 0;
        for (const auto *report : reports)
          n_resets += report->solves.empty() ? 0 : report->n_resets[s];
        segments << state.time << s + 1;
        add_segment(segments, solve, s);
        segments << n_resets << solve.qualities[s].liquid
                 << solve.qualities[s].wall
                 << (!step.relaxed.empty() && step.relaxed[s]);
        segments.end_row();
      }
    segments.flush();
  }



  void
  Results::write_resets(const StepRecord &step)
  {
    const auto reports = step.reports();
    for (unsigned int cycle = 0; cycle < reports.size(); ++cycle)
      {
        const auto &solves = reports[cycle]->solves;
        for (unsigned int k = 0; k < solves.size(); ++k)
          for (unsigned int s = 0; s < solves[k].segments.size(); ++s)
            {
              resets << step.time << cycle << k << s + 1;
              add_segment(resets, solves[k], s);
              resets << solves[k].segments[s].largest_deviator;
              resets.end_row();
            }
      }
    resets.flush();
  }



  void
  Results::write_reactions(const StepRecord &step)
  {
    if (step.external_forces.empty())
      {
        reactions.flush(); // its columns: a restart goes on with every table
        return;
      }
    const auto write_row = [&](const std::string   &kind,
                               const std::string   &name,
                               const ExternalForce &entry) {
      reactions << step.time << kind << csv_text(name);
      for (unsigned int c = 0; c < dim; ++c)
        reactions << entry.force[c];
      for (unsigned int c = 0; c < dim; ++c)
        reactions << entry.moment[c];
      reactions.end_row();
    };
    ExternalForce minimal_support, sum;
    bool          any = false;
    for (const ExternalForce &entry : step.external_forces)
      {
        sum += entry;
        if (entry.kind == ExternalForce::Kind::minimal_support)
          {
            minimal_support += entry;
            any = true;
          }
        else
          write_row(entry.kind == ExternalForce::Kind::symmetry ?
                      "symmetry plane" :
                      "boundary condition",
                    entry.name,
                    entry);
      }
    if (any)
      write_row("minimal support", "minimal support", minimal_support);
    write_row("sum", "sum", sum);
    reactions.flush();
  }



  void
  Results::write_steps(const StepRecord &step)
  {
    std::size_t n_solves = 0, n_newton_iterations = 0;
    for (const auto *report : step.reports())
      {
        n_solves += report->solves.size();
        n_newton_iterations += report->n_newton_iterations();
      }
    steps << step.number << step.time << step.size << step.n_cuts << n_solves
          << n_newton_iterations << step.n_linear_iterations
          << step.n_factorisations << step.softest_stiffness << step.seconds
          << step.elapsed_seconds;
    steps.end_row();
    steps.flush();
  }



  void
  Results::write_newton(const StepRecord &step)
  {
    const auto reports = step.reports();
    for (unsigned int cycle = 0; cycle < reports.size(); ++cycle)
      for (unsigned int k = 0; k < reports[cycle]->solves.size(); ++k)
        {
          unsigned int n = 0;
          for (const NewtonIteration &iteration :
               reports[cycle]->solves[k].newton)
            {
              newton << step.number << cycle << k + 1 << ++n
                     << iteration.residual.force << iteration.residual.volume
                     << iteration.increment << iteration.step_length;
              newton.end_row();
            }
        }
    newton.flush();
  }



  void
  Results::write_mesh(const StepRecord &step)
  {
    const auto write_row = [&](const unsigned int      cycle,
                               const AdaptationRecord &record) {
      const auto &n_resets = record.report.n_resets;
      mesh << step.number << step.time << cycle << record.n_cells
           << record.n_unknowns << record.n_refined << record.n_coarsened
           << (record.converged || !record.any) << record.estimated_error
           << record.volume_change << record.pressure_change
           << record.report.n_newton_iterations()
           << (n_resets.empty() ?
                 0 :
                 *std::max_element(n_resets.begin(), n_resets.end()));
      mesh.end_row();
    };

    if (step.number == 0)
      {
        AdaptationRecord at_first;
        at_first.n_cells    = space.triangulation.n_global_active_cells();
        at_first.n_unknowns = space.dof_handler.n_dofs();
        at_first.converged  = true;
        write_row(0, at_first);
      }
    for (unsigned int cycle = 0; cycle < step.adaptations.size(); ++cycle)
      write_row(cycle + 1, step.adaptations[cycle]);
    mesh.flush();
  }
} // namespace lumbricus
