// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/interruption.h>
#include <lumbricus/program/chain_problem.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace lumbricus
{
  ChainProblem::ChainProblem(RunParameters &parameters,
                             Log           &log,
                             const MPI_Comm comm)
    : parameters(parameters)
    , log(log)
    , comm(comm)
    , timer(std::cout,
            dealii::TimerOutput::never,
            dealii::TimerOutput::wall_times)
    , triangulation(comm)
    , space(triangulation)
    , shapes(space)
    , references(space,
                 shapes,
                 parameters.anatomy,
                 parameters.reset_iteration.mode())
    , supports(space,
               parameters.anatomy,
               parameters.interface_coupling,
               parameters.boundary_conditions)
    , assembler(space,
                shapes,
                parameters.anatomy,
                parameters.boundary_conditions,
                references,
                supports)
    , equilibrium(space,
                  shapes,
                  parameters.anatomy,
                  assembler,
                  supports,
                  *parameters.linear_solver.get(),
                  timer)
  {}



  void
  ChainProblem::setup(const Checkpoint *checkpoint)
  {
    dealii::TimerOutput::Scope scope(timer, "setup");
    parameters.anatomy.geometry().create_coarse_mesh(triangulation);
    const auto is_liquid = [&](const dealii::types::material_id id) {
      return parameters.anatomy.is_liquid(Region::of(id).tissue);
    };
    const bool slips = parameters.interface_coupling.slips();
    if (checkpoint != nullptr)
      checkpoint->refine(triangulation);
    else
      parameters.mesh_refinement.refine(
        triangulation, [&](const auto one_side, const auto other_side) {
          return slips && is_liquid(one_side) != is_liquid(other_side);
        });
    space.set_finest_curved_level(
      parameters.mesh_refinement.n_global_refinements());
    space.distribute_dofs(slips ? MixedSpace::Separate(is_liquid) :
                                  MixedSpace::Separate());
    shapes.reinit();
    references.reinit();
    supports.reinit();
    parameters.try_expressions(triangulation);
    equilibrium.reinit();
  }



  void
  ChainProblem::describe()
  {
    const auto &geometry = parameters.anatomy.geometry();
    log << (parameters.title.empty() ? "" : parameters.title + "\n")
        << geometry.n_segments() << " segment"
        << (geometry.n_segments() == 1 ? "" : "s") << ", "
        << triangulation.n_global_active_cells() << " cells, "
        << space.dof_handler.n_dofs() << " unknowns, "
        << dealii::Utilities::MPI::n_mpi_processes(comm) << " rank"
        << (dealii::Utilities::MPI::n_mpi_processes(comm) == 1 ? "" : "s")
        << "\n";
  }



  void
  ChainProblem::run(RunFolder         &folder,
                    const std::string &resolved_parameters,
                    const Checkpoint  *checkpoint)
  {
    if (checkpoint != nullptr)
      folder.continue_tables(checkpoint->progress().table_sizes);
    Results    results(folder,
                    space,
                    shapes,
                    parameters.anatomy,
                    references,
                    parameters.probe_points.points(),
                    parameters.output_every);
    State      state = space.initial_state();
    StepRecord step;
    if (checkpoint != nullptr)
      go_on_from(*checkpoint, state, step, results);
    references.update(state);
    if (checkpoint == nullptr)
      results.write(state, step);

    const auto save = [&]() {
      dealii::TimerOutput::Scope scope(timer, "checkpoints");
      write_checkpoint(folder,
                       triangulation,
                       space,
                       state,
                       progress(state, step, results),
                       resolved_parameters);
      parameters.checkpoint_schedule.written();
    };

    std::string        trouble;
    std::ostringstream last_state;
    try
      {
        take_steps(state, step, results, save);
      }
    catch (const ExcInterrupted &exception)
      {
        save();
        log_where_time_went();
        AssertThrow(false,
                    ExcInterrupted(plain_message(exception) +
                                   "\nGo on with: lumbricus --restart '" +
                                   folder.path() + "'"));
      }
    catch (const dealii::ExceptionBase &exception)
      {
        // Only these two are thrown on all ranks; anything else is a bug.
        if (dynamic_cast<const ExcInput *>(&exception) == nullptr &&
            dynamic_cast<const ExcSolveFailed *>(&exception) == nullptr)
          throw;
        trouble = plain_message(exception);
      }

    // The last good state is what the run leaves.
    references.update(state);
    results.write_last(state);
    if (parameters.checkpoint_schedule.any())
      save_or_say(save);
    log_where_time_went();
    last_state << "\nThe last good state, at time " << state.time << ", is in '"
               << folder.path() << "'.";
    AssertThrow(trouble.empty(), ExcSolveFailed(trouble + last_state.str()));
  }



  void
  ChainProblem::take_steps(State                       &state,
                           StepRecord                  &step,
                           Results                     &results,
                           const std::function<void()> &save)
  {
    log << "\n  step        time   done   Newton  resets  divergence   seconds"
           "        left\n";
    while (!parameters.load_stepping.finished(state.time))
      {
        step = advance(state, step.number + 1);
        log_step(step);
        results.write(state, step);
        if (parameters.checkpoint_schedule.due(step.number, comm))
          {
            save_or_say(save);
            // So that a run that goes on from here does the same.
            equilibrium.forget_factors();
          }
      }
  }



  void
  ChainProblem::save_or_say(const std::function<void()> &save)
  {
    try
      {
        save();
      }
    catch (const ExcSolveFailed &exception)
      {
        log << "        no checkpoint: " << plain_message(exception)
            << ". The last one is still there.\n";
      }
  }



  RunProgress
  ChainProblem::progress(const State      &state,
                         const StepRecord &step,
                         const Results    &results) const
  {
    RunProgress progress;
    progress.time            = state.time;
    progress.step            = step.number;
    progress.step_size       = parameters.load_stepping.step();
    progress.elapsed_seconds = step.elapsed_seconds;
    results.note(progress);
    return progress;
  }



  void
  ChainProblem::go_on_from(const Checkpoint &checkpoint,
                           State            &state,
                           StepRecord       &step,
                           Results          &results)
  {
    const RunProgress &progress = checkpoint.progress();
    state                       = checkpoint.read_state(space);
    step.number                 = progress.step;
    step.elapsed_seconds        = progress.elapsed_seconds;
    seconds_before_restart      = progress.elapsed_seconds;
    parameters.load_stepping.set_step(progress.step_size);
    results.continue_after(progress);
    log << "Going on from time " << state.time << ", after step " << step.number
        << ".\n";
  }



  StepRecord
  ChainProblem::advance(State &state, const unsigned int number)
  {
    LoadStepping       &stepping = parameters.load_stepping;
    const dealii::Timer step_timer;
    const auto          before = parameters.linear_solver->statistics();

    StepRecord step;
    step.number = number;
    for (;; ++step.n_cuts)
      try
        {
          State next = state;
          next.time  = stepping.next_time(state.time);
          references.update(next);
          parameters.boundary_conditions.try_expressions(triangulation,
                                                         {next.time});
          equilibrium.set_time(next.time, next.solution);
          const auto report =
            parameters.reset_iteration.solve(next,
                                             equilibrium,
                                             parameters.newton,
                                             references,
                                             space,
                                             shapes,
                                             parameters.anatomy);

          step.time   = next.time;
          step.size   = next.time - state.time;
          step.report = report;
          state       = next;
          stepping.accept(report.solves.front().newton.size());
          break;
        }
      catch (const ExcNotConverged &exception)
        {
          stepping.cut(state.time, plain_message(exception));
          log << "        cut to " << stepping.step() << ": "
              << plain_message(exception) << "\n";
        }

    const auto after         = parameters.linear_solver->statistics();
    step.n_linear_iterations = after.n_iterations - before.n_iterations;
    step.n_factorisations    = after.n_factorisations - before.n_factorisations;
    step.seconds             = step_timer.wall_time();
    step.elapsed_seconds     = seconds_before_restart + run_timer.wall_time();
    return step;
  }



  void
  ChainProblem::log_step(const StepRecord &step)
  {
    const double done = step.time / parameters.load_stepping.end_time();
    const double left = step.elapsed_seconds * (1. - done) / done;

    const auto &n_resets   = step.report.n_resets;
    const auto &divergence = step.report.solves.back().divergence;

    std::ostringstream line;
    line << std::setw(6) << step.number << std::setw(12) << std::setprecision(6)
         << step.time << std::setw(6) << std::fixed << std::setprecision(0)
         << 100. * done << "%" << std::setw(9)
         << step.report.n_newton_iterations() << std::setw(8)
         << *std::max_element(n_resets.begin(), n_resets.end()) << std::setw(12)
         << std::scientific << std::setprecision(1)
         << *std::max_element(divergence.begin(), divergence.end())
         << std::setw(10) << std::fixed << std::setprecision(1) << step.seconds
         << std::setw(10) << std::setprecision(0) << left << " s\n";
    log << line.str();
  }



  void
  ChainProblem::log_where_time_went()
  {
    const double       total = run_timer.wall_time();
    std::ostringstream table;
    table << "\nWhere the time went" << std::setw(20) << "seconds"
          << std::setw(8) << "share" << std::setw(9) << "calls\n";
    const auto seconds =
      timer.get_summary_data(dealii::TimerOutput::total_wall_time);
    const auto calls = timer.get_summary_data(dealii::TimerOutput::n_calls);
    const auto row   = [&](const std::string &name, const double s) {
      table << "  " << std::left << std::setw(25) << name << std::right
            << std::fixed << std::setw(12) << std::setprecision(2) << s
            << std::setw(7) << std::setprecision(0) << 100. * s / total << "%";
    };
    for (const auto &[name, s] : seconds)
      {
        row(name, s);
        table << std::setw(8) << calls.at(name) << "\n";
      }
    row("total", total);

    dealii::Utilities::System::MemoryStats memory;
    dealii::Utilities::System::get_memory_stats(memory);
    const double most = dealii::Utilities::MPI::max(memory.VmHWM / 1024., comm);
    table << "\nPeak memory of the largest rank: " << std::setprecision(0)
          << most << " MB; "
          << parameters.linear_solver->statistics().n_factorisations
          << " factorisations, "
          << parameters.linear_solver->statistics().n_iterations
          << " linear iterations.\n";
    log << table.str();
  }
} // namespace lumbricus
