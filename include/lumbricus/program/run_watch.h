// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_run_watch_h
#define lumbricus_program_run_watch_h

#include <lumbricus/core/log.h>
#include <lumbricus/output/step_record.h>
#include <lumbricus/program/run_parameters.h>

#include <deal.II/base/timer.h>

#include <set>

namespace lumbricus
{
  /**
   * Tells of a load step while it goes on: where somebody watches, one line
   * that says where the run is and how long it may still take; with --verbose a
   * line for every Newton iteration and every reset; and a warning where cells
   * fold.
   */
  class RunWatch
  {
  public:
    /** Listen to the solvers of @p parameters, which are initialized. */
    RunWatch(RunParameters       &parameters,
             Log                 &log,
             const dealii::Timer &run_timer);

    RunWatch(const RunWatch &) = delete;

    /** From @p start on, the time left is estimated. */
    void
    begin_run(const double start);

    /** The load step @p number to time @p to is tried. */
    void
    begin_step(const unsigned int number, const double to);

    /** The load step has converged: warn of what makes its results doubtful. */
    void
    end_step(const StepRecord &record);

  private:
    void
    iterated(const NewtonIteration &iteration);

    void
    solved(const ResetIteration::Solve &solve,
           const std::vector<bool>     &is_reset);

    void
    show_progress();

    const LoadStepping  &stepping;
    const LinearSolver  &linear_solver;
    Log                 &log;
    const dealii::Timer &run_timer;

    double       start_time    = 0.;
    double       start_seconds = 0.;
    double       reached       = 0.;
    unsigned int step          = 0;
    double       next_time     = 0.;
    unsigned int n_resets      = 0;
    unsigned int n_iterations  = 0; ///< of this solve

    LinearSolverStatistics counted; ///< up to the last iteration
    std::set<unsigned int> folded;  ///< segments there was a warning of
    bool unbalanced = false;        ///< whether there was one of the loads
  };
} // namespace lumbricus

#endif
