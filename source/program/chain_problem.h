// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_chain_problem_h
#define lumbricus_program_chain_problem_h

#include <lumbricus/checkpoint/checkpoint.h>
#include <lumbricus/core/log.h>
#include <lumbricus/output/results.h>
#include <lumbricus/output/run_description.h>
#include <lumbricus/program/chain_model.h>
#include <lumbricus/program/run_watch.h>

#include <deal.II/base/timer.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "double_steps.h"
#include "error_estimates.h"
#include "locking_watch.h"

namespace lumbricus
{
  /**
   * A run: the steps of a Continuation on a model of the body, adaptation of its
   * mesh, results and checkpoints. It composes and computes nothing itself.
   */
  class ChainProblem
  {
  public:
    /** Without a mesh, see setup(). All of these are kept by reference. */
    ChainProblem(RunParameters &parameters, Log &log, const MPI_Comm comm);

    /** Make the model, on the mesh of @p checkpoint where there is one. Throws
     * ExcInput. */
    void
    setup(const Checkpoint *checkpoint);

    /** Say how many cells and unknowns there are. */
    void
    describe();

    /**
     * Read the state of @p checkpoint, where there is one, and find out whether
     * results can be written to @p folder, which is kept by reference, and
     * whether those up to the checkpoint are as they were. Throws ExcInput.
     * After setup() and before RunFolder::begin(). Collective.
     */
    void
    prepare(RunFolder &folder, const Checkpoint *checkpoint);

    /**
     * Begin the results, or continue those up to @p checkpoint, where there is
     * one, so that there is a state on disk that run() can leave as the last
     * good one. After RunFolder::begin(). Throws ExcSolveFailed. Collective.
     */
    void
    begin(const Checkpoint *checkpoint);

    /**
     * Compute the run and write its results to @p folder, that of prepare();
     * @p request is for its checkpoints. After begin(). Throws ExcSolveFailed
     * and ExcInterrupted, with the last good state on disk. Collective.
     */
    void
    run(RunFolder &folder, const RunRequest &request);

    /** The mesh, after setup(). */
    const dealii::Triangulation<dim> &
    mesh() const;

    /** How many unknowns there are, after setup(). */
    std::uint64_t
    n_unknowns() const;

    /** How far the run has come, after prepare(); with its costs when run() has
     * ended. It knows of no end: that is running. */
    const RunStatus &
    status() const;

  private:
    /** The steps of a run, which change @p state and @p step. */
    void
    take_steps(State                       &state,
               StepRecord                  &step,
               const std::function<void()> &save);

    /** Save, and where that is not possible say so and go on. */
    void
    save_or_say(const std::function<void()> &save);

    /** @return what to remember besides the state. */
    RunProgress
    progress(const State &state, const StepRecord &step) const;

    /** Let the continuation go on where it was at @p checkpoint, if it is the
     * same. Throws ExcInput. */
    void
    continue_path(const Checkpoint &checkpoint);

    /** Go on from a checkpoint, whose state and step are the first. */
    void
    go_on_from(const Checkpoint &checkpoint);

    /** Adapt the mesh to @p state, which has converged. */
    void
    adapt(State &state, StepRecord &step);

    /** Note that @p state is reached by @p step. */
    void
    note_reached(const State &state, const StepRecord &step);

    void
    log_where_time_went();

    /** What the run has cost so far. */
    struct Costs
    {
      double       seconds;
      unsigned int n_iterations;
      unsigned int n_factorisations;
    };

    Costs
    costs() const;

    /** Note what @p step has cost, which began at @p before. */
    void
    charge(StepRecord &step, const Costs &before) const;

    RunParameters &parameters;
    Log           &log;
    const MPI_Comm comm;

    dealii::Timer            run_timer;
    double                   seconds_before_restart = 0.;
    dealii::TimerOutput      timer;
    ChainModel               model;
    ErrorEstimates           error_estimates;
    DoubleSteps              double_steps;
    RunWatch                 watch;
    LockingWatch             locking_watch;
    std::unique_ptr<Results> results;
    State                    first_state; ///< of this part of the run
    StepRecord               first_step;  ///< that led to it
    RunStatus                so_far;

    /** What tables have to say about the first mesh. */
    std::string table_notes;
  };
} // namespace lumbricus

#endif
