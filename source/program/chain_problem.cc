// SPDX-License-Identifier: LGPL-2.1-or-later
#include "chain_problem.h"

#include <lumbricus/anatomy/fibre_warnings.h>
#include <lumbricus/anatomy/stiffness_ratio.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/interruption.h>
#include <lumbricus/core/out_of_memory.h>

#include <iostream>
#include <sstream>

#include "mesh_adaptation.h"
#include "reset_errors.h"
#include "run_log.h"
#include "stride_warning.h"

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
    , error_estimates(model)
    , double_steps(model, parameters.output_parts.asks_for_errors_of_steps())
    , watch(parameters, log, run_timer)
  {}



  void
  ChainProblem::setup(const Checkpoint *checkpoint)
  {
    dealii::TimerOutput::Scope scope(timer, "setup");
    model.create(checkpoint);
    // A run that goes on keeps the points that it took on its first mesh.
    if (checkpoint == nullptr)
      table_notes = parameters.output_parts.check(model.space);
  }



  void
  ChainProblem::describe()
  {
    const auto &geometry = parameters.anatomy.geometry();
    log << (parameters.title.empty() ? "" : parameters.title + "\n")
        << geometry.n_segments() << " segment"
        << (geometry.n_segments() == 1 ? "" : "s") << ", "
        << model.triangulation.n_global_active_cells() << " cells, "
        << n_unknowns() << " unknowns, "
        << dealii::Utilities::MPI::n_mpi_processes(comm) << " rank"
        << (dealii::Utilities::MPI::n_mpi_processes(comm) == 1 ? "" : "s")
        << "\n"
        << parameters.unit_check.warnings(parameters.anatomy)
        << StiffnessRatio(parameters.anatomy).warning()
        << fibre_warnings(parameters.anatomy) << double_steps.note()
        << table_notes;
  }



  void
  ChainProblem::prepare(RunFolder &folder, const Checkpoint *checkpoint)
  {
    first_state = model.rest_state();
    double_steps.begin(first_state);
    if (checkpoint != nullptr)
      {
        double_steps.check(*checkpoint, first_state);
        first_state =
          checkpoint->read_state(model.space, first_state.outline());
        continue_path(*checkpoint);
        folder.continue_tables(checkpoint->progress().tables);
        so_far.step    = checkpoint->progress().step;
        so_far.time    = checkpoint->progress().time;
        so_far.seconds = checkpoint->progress().elapsed_seconds;
      }
    so_far.end_time = parameters.load_stepping.end_time();
    results = std::make_unique<Results>(folder,
                                        model.body,
                                        model.references,
                                        model.liquid_weight,
                                        parameters.boundary_conditions,
                                        parameters.output_parts,
                                        parameters.output_every);
    parameters.continuation.get()->open(model);
  }



  void
  ChainProblem::begin(const Checkpoint *checkpoint)
  {
    if (checkpoint != nullptr)
      go_on_from(*checkpoint);
    model.references.update(first_state);
    model.liquid_weight.set_time(first_state.time);
    first_step.contacts = model.contacts_of_body(first_state);
    first_step.motion   = model.motion_of_body(first_state);
    if (checkpoint == nullptr)
      results->write(first_state, first_step);
  }



  void
  ChainProblem::run(RunFolder &folder, const RunRequest &request)
  {
    State      state = first_state;
    StepRecord step  = first_step;
    note_reached(state, step);

    const auto save = [&]() {
      dealii::TimerOutput::Scope scope(timer, "checkpoints");
      write_checkpoint(folder,
                       model.triangulation,
                       model.space,
                       state,
                       progress(state, step),
                       request);
      parameters.checkpoint_schedule.written();
    };

    std::string trouble;
    try
      {
        take_steps(state, step, save);
      }
    catch (const ExcInterrupted &exception)
      {
        log.note("\n" + plain_message(exception) + "\n");
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
    model.liquid_weight.set_time(state.time);
    results->write_last(state);
    if (parameters.checkpoint_schedule.any())
      save_or_say(save);
    if (trouble.empty())
      log << stride_warning(parameters.anatomy,
                            parameters.boundary_conditions,
                            step.motion);
    log_where_time_went();
    std::ostringstream last_state;
    last_state << "\nThe last good state, at time " << state.time << ", is in '"
               << folder.path() << "'.";
    if (trouble.empty())
      return;
    log.note("\n" + trouble + last_state.str() + "\n");
    AssertThrow(false, ExcSolveFailed(trouble + last_state.str()));
  }



  const dealii::Triangulation<dim> &
  ChainProblem::mesh() const
  {
    return model.triangulation;
  }



  std::uint64_t
  ChainProblem::n_unknowns() const
  {
    return model.space.dof_handler.n_dofs();
  }



  const RunStatus &
  ChainProblem::status() const
  {
    return so_far;
  }



  void
  ChainProblem::note_reached(const State &state, const StepRecord &step)
  {
    so_far.step    = step.number;
    so_far.time    = state.time;
    so_far.seconds = step.elapsed_seconds;
  }



  void
  ChainProblem::take_steps(State                       &state,
                           StepRecord                  &step,
                           const std::function<void()> &save)
  {
    Continuation &continuation = *parameters.continuation.get();
    log_header(log);
    watch.begin_run(state.time);
    while (!continuation.finished(model, state))
      {
        const Costs before = costs();
        State       next;
        StepRecord  record;
        with_memory_message(comm, [&]() {
          next   = state;
          record =
            continuation.advance(model, next, step.number + 1, watch, log);
        });
        const bool asks_for_work = parameters.output_parts.asks_for_work();
        if (asks_for_work)
          record.work = model.work_of_step(state, next);
        if (parameters.adaptivity.due(record.number))
          adapt(next, record);
        if (asks_for_work && !record.adaptations.empty())
          record.work.remeshed = model.stored_energy(next) - record.work.stored;
        record.external_forces = model.forces_on_body(next);
        record.contacts        = model.contacts_of_body(next);
        record.motion          = model.motion_of_body(next);
        record.motion.speed =
          (record.motion.stride - step.motion.stride) / record.size;
        record.softest_stiffness =
          parameters.stability_watch.look(model, next, log);
        locking_watch.look(model.body, model.references, next, log);
        if (parameters.output_parts.asks_for_errors(record.number))
          record.errors =
            error_estimates.estimate(next,
                                     record.reports().back()->solves.back(),
                                     log);
        record.errors_of_steps =
          double_steps.errors(next, record.reports().back()->solves.back(), log);
        if (parameters.output_parts.asks_for_errors_of_resets(record.number))
          record.errors_of_resets =
            errors_of_resets(model,
                             next,
                             record.reports().back()->solves.back(),
                             log);
        model.end_step(next);
        charge(record, before);
        state = next;
        step  = record;
        note_reached(state, step);

        log_step(log, step, parameters.load_stepping.end_time());
        for (const AdaptationRecord &adaptation : step.adaptations)
          log_adaptation(log, adaptation);
        log_errors(log, step);
        watch.end_step(step);
        {
          dealii::TimerOutput::Scope scope(timer, "output");
          results->write(state, step);
        }
        if (parameters.checkpoint_schedule.due(step.number, comm))
          {
            save_or_say(save);
            // So that a run that goes on from here does the same to the last
            // digit. Where the clock said so this run is to go on as if there
            // were no clock.
            if (parameters.checkpoint_schedule.due_by_number(step.number))
              model.equilibrium.forget_factors();
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
    so_far.costs   = run_costs(timer,
                             run_timer.wall_time(),
                             parameters.linear_solver->statistics(),
                             comm);
    so_far.seconds = seconds_before_restart + so_far.costs->seconds;
    log_costs(log, *so_far.costs);
  }



  RunProgress
  ChainProblem::progress(const State &state, const StepRecord &step) const
  {
    RunProgress progress;
    progress.time            = state.time;
    progress.step            = step.number;
    progress.control         = parameters.continuation.chosen_name();
    progress.numbers         = parameters.continuation->numbers();
    progress.elapsed_seconds = step.elapsed_seconds;
    const StateOutline outline = state.outline();
    progress.histories         = outline.histories;
    progress.past              = outline.past;
    progress.globals           = outline.globals;
    results->note(progress);
    return progress;
  }



  void
  ChainProblem::continue_path(const Checkpoint &checkpoint)
  {
    const RunProgress &progress = checkpoint.progress();
    if (progress.control != parameters.continuation.chosen_name())
      return;
    AssertThrow(parameters.continuation.get()->set_numbers(progress.numbers),
                ExcInput("The checkpoint '" + checkpoint.path() +
                         "' has numbers that 'Path/Control' = '" +
                         progress.control +
                         "' cannot go on with. Set another one, or start the "
                         "run from its parameter file."));
  }



  void
  ChainProblem::go_on_from(const Checkpoint &checkpoint)
  {
    const RunProgress &progress = checkpoint.progress();
    first_step.number           = progress.step;
    first_step.elapsed_seconds  = progress.elapsed_seconds;
    seconds_before_restart      = progress.elapsed_seconds;
    results->continue_after(progress);
    log << "Going on from time " << first_state.time << ", after step "
        << first_step.number << ".\n";
    const std::string &control = parameters.continuation.chosen_name();
    if (control != progress.control)
      log << "From here on by 'Path/Control' = '" << control
          << "', which begins anew; so far it was '" << progress.control
          << "'.\n";
  }



  void
  ChainProblem::adapt(State &state, StepRecord &step)
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
    results->reinit();
    error_estimates.reinit();
    parameters.continuation->adapted(state);
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
