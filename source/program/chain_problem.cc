// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/interruption.h>
#include <lumbricus/program/chain_problem.h>
#include <lumbricus/program/diagnosis.h>
#include <lumbricus/program/mesh_adaptation.h>
#include <lumbricus/program/run_log.h>

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
    , model(parameters, timer, comm)
    , watch(parameters, log, run_timer)
  {}



  void
  ChainProblem::setup(const Checkpoint *checkpoint)
  {
    dealii::TimerOutput::Scope scope(timer, "setup");
    model.create(checkpoint);
    // A run that goes on keeps the points that it took on its first mesh.
    if (checkpoint == nullptr)
      point_notes =
        Probes::check(parameters.probe_points.points(), model.space);
  }



  void
  ChainProblem::describe()
  {
    const auto &geometry = parameters.anatomy.geometry();
    log << (parameters.title.empty() ? "" : parameters.title + "\n")
        << geometry.n_segments() << " segment"
        << (geometry.n_segments() == 1 ? "" : "s") << ", "
        << model.triangulation.n_global_active_cells() << " cells, "
        << model.space.dof_handler.n_dofs() << " unknowns, "
        << dealii::Utilities::MPI::n_mpi_processes(comm) << " rank"
        << (dealii::Utilities::MPI::n_mpi_processes(comm) == 1 ? "" : "s")
        << "\n"
        << parameters.unit_check.warnings(parameters.anatomy) << point_notes;
  }



  void
  ChainProblem::run(RunFolder         &folder,
                    const std::string &resolved_parameters,
                    const Checkpoint  *checkpoint)
  {
    if (checkpoint != nullptr)
      folder.continue_tables(checkpoint->progress().table_sizes);
    Results    results(folder,
                    model.space,
                    model.shapes,
                    parameters.anatomy,
                    model.references,
                    parameters.probe_points.points(),
                    parameters.output_every);
    State      state = model.space.initial_state();
    StepRecord step;
    if (checkpoint != nullptr)
      go_on_from(*checkpoint, state, step, results);
    model.references.update(state);
    parameters.predictor.restart(state);
    if (checkpoint == nullptr)
      results.write(state, step);
    begun = true;

    const auto save = [&]() {
      dealii::TimerOutput::Scope scope(timer, "checkpoints");
      write_checkpoint(folder,
                       model.triangulation,
                       model.space,
                       state,
                       progress(state, step, results),
                       resolved_parameters);
      parameters.checkpoint_schedule.written();
    };

    std::string trouble;
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
        if (!is_thrown_on_all_ranks(exception))
          throw;
        trouble = plain_message(exception);
      }

    // The last good state is what the run leaves.
    model.references.update(state);
    results.write_last(state);
    if (parameters.checkpoint_schedule.any())
      save_or_say(save);
    log_where_time_went();
    std::ostringstream last_state;
    last_state << "\nThe last good state, at time " << state.time << ", is in '"
               << folder.path() << "'.";
    AssertThrow(trouble.empty(), ExcSolveFailed(trouble + last_state.str()));
  }



  bool
  ChainProblem::has_begun() const
  {
    return begun;
  }



  void
  ChainProblem::take_steps(State                       &state,
                           StepRecord                  &step,
                           Results                     &results,
                           const std::function<void()> &save)
  {
    log_header(log);
    watch.begin_run(state.time);
    while (!parameters.load_stepping.finished(state.time))
      {
        const Costs before = costs();
        State       next   = state;
        StepRecord  record = advance(next, step.number + 1);
        if (parameters.adaptivity.due(record.number))
          adapt(next, record, results);
        record.softest_stiffness =
          parameters.stability_watch.look(model, next, log);
        charge(record, before);
        state = next;
        step  = record;

        log_step(log, step, parameters.load_stepping.end_time());
        for (const AdaptationRecord &adaptation : step.adaptations)
          log_adaptation(log, adaptation);
        watch.end_step(step);
        {
          dealii::TimerOutput::Scope scope(timer, "output");
          results.write(state, step);
        }
        if (parameters.checkpoint_schedule.due(step.number, comm))
          {
            save_or_say(save);
            // So that a run that goes on from here does the same.
            model.equilibrium.forget_factors();
            parameters.predictor.restart(state);
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
            << " The last one is still there.\n";
      }
  }



  void
  ChainProblem::log_where_time_went()
  {
    log_costs(log,
              timer,
              run_timer.wall_time(),
              parameters.linear_solver->statistics(),
              comm);
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
    state                       = checkpoint.read_state(model.space);
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
    LoadStepping &stepping = parameters.load_stepping;
    StepRecord    step;
    step.number = number;

    const auto relaxation = model.relax_liquid_mesh(state);
    if (!relaxation.in_segment.empty())
      {
        step.relaxed = relaxation.in_segment;
        parameters.predictor.shift(relaxation.change);
      }
    while (true)
      try
        {
          State next = state;
          next.time  = stepping.next_time(state.time);
          watch.begin_step(number, next.time);
          parameters.predictor.predict(next);
          step.report = model.solve(next);
          step.time   = next.time;
          step.size   = next.time - state.time;
          state       = next;
          stepping.accept(step.report.solves.front().newton.size());
          parameters.predictor.accept(state);
          return step;
        }
      catch (const ExcNotConverged &exception)
        {
          // Without the predictor before a shorter step.
          if (parameters.predictor.ready())
            {
              parameters.predictor.restart(state);
              continue;
            }
          const std::string why = plain_message(exception);
          try
            {
              stepping.cut(state.time, why);
            }
          catch (const ExcSolveFailed &failure)
            {
              AssertThrow(false,
                          ExcSolveFailed(
                            plain_message(failure) +
                            diagnose(model, state, stepping.step())));
            }
          ++step.n_cuts;
          log << "        cut to " << stepping.step() << ": " << why << "\n";
        }
  }



  void
  ChainProblem::adapt(State &state, StepRecord &step, Results &results)
  {
    bool any = false;
    for (unsigned int i = 0; i < parameters.adaptivity.n_cycles(); ++i)
      {
        const auto record =
          adapt_mesh(model, state, step.reports().back()->solves.back(), log);
        step.adaptations.push_back(record);
        any = any || record.any;
        if (!record.converged)
          break;
      }
    if (!any)
      return;
    results.reinit();
    parameters.predictor.restart(state);
  }



  ChainProblem::Costs
  ChainProblem::costs() const
  {
    const auto &solver = parameters.linear_solver->statistics();
    return {run_timer.wall_time(),
            solver.n_iterations,
            solver.n_factorisations};
  }



  void
  ChainProblem::charge(StepRecord &step, const Costs &before) const
  {
    const Costs now          = costs();
    step.seconds             = now.seconds - before.seconds;
    step.elapsed_seconds     = seconds_before_restart + now.seconds;
    step.n_linear_iterations = now.n_iterations - before.n_iterations;
    step.n_factorisations    = now.n_factorisations - before.n_factorisations;
  }
} // namespace lumbricus
