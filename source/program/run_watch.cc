// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/program/run_watch.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

#include "load_balance.h"

namespace lumbricus
{
  RunWatch::RunWatch(RunParameters       &parameters,
                     Log                 &log,
                     const dealii::Timer &run_timer)
    : stepping(parameters.load_stepping)
    , linear_solver(*parameters.linear_solver.get())
    , log(log)
    , run_timer(run_timer)
  {
    parameters.linear_solver.get()->report_to(
      [&log](const std::string &message) {
        log << "        " << message << "\n";
      });
    parameters.newton.report_to(
      [this](const NewtonIteration &iteration) { iterated(iteration); });
    parameters.reset_iteration.report_to(
      [this](const ResetIteration::Solve &solve,
             const std::vector<bool> &is_reset) { solved(solve, is_reset); });
  }



  void
  RunWatch::begin_run(const double start)
  {
    start_time    = start;
    start_seconds = run_timer.wall_time();
    reached       = start;
  }



  void
  RunWatch::begin_step(const unsigned int number, const double to)
  {
    step         = number;
    next_time    = to;
    n_resets     = 0;
    n_iterations = 0;
    counted      = linear_solver.statistics();
    std::ostringstream line;
    line << "step " << step << ", to time " << next_time;
    log.detail(line.str());
    show_progress();
  }



  void
  RunWatch::end_step(const StepRecord &record)
  {
    reached               = record.time;
    const std::string why = unbalanced ? "" : imbalance(record.external_forces);
    unbalanced            = unbalanced || !why.empty();
    if (!why.empty())
      {
        std::ostringstream line;
        line << "        Warning: from time " << record.time << " on " << why
             << "\n";
        log << line.str();
      }
    const auto &qualities = record.reports().back()->solves.back().qualities;
    for (unsigned int s = 0; s < qualities.size(); ++s)
      if (qualities[s].wall <= 0. && folded.insert(s).second)
        {
          std::ostringstream line;
          line << "        Warning: from time " << record.time
               << " on the wall of segment " << s + 1
               << " has a cell that is folded (wall_mesh_quality "
               << std::setprecision(2) << qualities[s].wall
               << "). Stresses near it are not to be trusted; try a finer mesh "
                  "or one of another shape there.\n";
          log << line.str();
        }
  }



  void
  RunWatch::iterated(const NewtonIteration &iteration)
  {
    ++n_iterations;
    const LinearSolverStatistics now = linear_solver.statistics();
    const unsigned int n_linear      = now.n_iterations - counted.n_iterations;
    const bool factorised = now.n_factorisations > counted.n_factorisations;
    counted               = now;

    std::ostringstream line;
    line << "  Newton " << n_iterations << ": " << std::scientific
         << std::setprecision(1) << "force " << iteration.residual.force
         << ", volume " << iteration.residual.volume << ", increment "
         << iteration.increment << std::defaultfloat << ", step length "
         << iteration.step_length << "; " << n_linear << " linear iteration"
         << (n_linear == 1 ? "" : "s") << (factorised ? ", factorised" : "");
    log.detail(line.str());
    show_progress();
  }



  void
  RunWatch::solved(const ResetIteration::Solve &solve,
                   const std::vector<bool>     &is_reset)
  {
    const auto worst =
      std::max_element(solve.divergence.begin(), solve.divergence.end());
    const auto n = std::count(is_reset.begin(), is_reset.end(), true);

    std::ostringstream line;
    line << "  solved; divergence " << std::scientific << std::setprecision(1)
         << *worst << " in segment " << worst - solve.divergence.begin() + 1;
    if (n > 0)
      line << "; reset " << ++n_resets << ", of " << n << " segment"
           << (n == 1 ? "" : "s");
    n_iterations = 0;
    log.detail(line.str());
    show_progress();
  }



  void
  RunWatch::show_progress()
  {
    const double       seconds = run_timer.wall_time();
    const double       end     = stepping.end_time();
    std::ostringstream line;
    line << "        step " << step << ", to time " << next_time << " of "
         << end << ": reset " << n_resets << ", Newton " << n_iterations << "; "
         << std::fixed << std::setprecision(0) << seconds << " s";
    if (reached > start_time)
      line << ", about "
           << (seconds - start_seconds) * (end - reached) /
                (reached - start_time)
           << " s left";
    log.progress(line.str());
  }
} // namespace lumbricus
