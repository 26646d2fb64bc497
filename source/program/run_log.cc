// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/program/run_log.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace lumbricus
{
  void
  log_header(Log &log)
  {
    log << "\n  step        time   done   Newton  resets  divergence   seconds"
           "        left\n";
  }



  void
  log_step(Log &log, const StepRecord &step, const double end_time)
  {
    const double done = step.time / end_time;
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
  log_adaptation(Log &log, const AdaptationRecord &record)
  {
    std::ostringstream line;
    line << "        mesh: " << record.n_cells << " cells (" << record.n_refined
         << " cut, " << record.n_coarsened << " merged), " << record.n_unknowns
         << " unknowns; error before " << std::setprecision(2)
         << 100. * record.estimated_error << "%";
    if (record.converged)
      line << "; pressure changed by " << 100. * record.pressure_change << "%; "
           << record.report.n_newton_iterations() << " Newton, "
           << *std::max_element(record.report.n_resets.begin(),
                                record.report.n_resets.end())
           << " resets";
    log << line.str() << "\n";
  }



  void
  log_costs(Log                          &log,
            const dealii::TimerOutput    &timer,
            const double                  total,
            const LinearSolverStatistics &statistics,
            const MPI_Comm                comm)
  {
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
        if (name == "linear solver")
          {
            row("  factorisation", statistics.factor_seconds);
            table << std::setw(8) << statistics.n_factorisations << "\n";
            row("  iterations", statistics.solve_seconds);
            table << std::setw(8) << statistics.n_iterations << "\n";
          }
      }
    row("total", total);

    dealii::Utilities::System::MemoryStats memory;
    dealii::Utilities::System::get_memory_stats(memory);
    const double most = dealii::Utilities::MPI::max(memory.VmHWM / 1024., comm);
    table << "\nPeak memory of the largest rank: " << std::setprecision(0)
          << most << " MB.\nMost iterations of a linear solve: "
          << statistics.most_iterations << ".\n";
    log << table.str();
  }
} // namespace lumbricus
