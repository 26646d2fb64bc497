// SPDX-License-Identifier: LGPL-2.1-or-later

#include "run_log.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace lumbricus
{
  namespace
  {
    // A line with the largest errors @p errors of the numbers of @p solve; nothing
    // where there are none.
    std::string
    line_of_errors(const std::string               &what,
                   const std::vector<SegmentError> &errors,
                   const ResetIteration::Solve     &solve)
    {
      // The largest of all segments that have the number; NaN where none has.
      const auto largest = [&](const auto &of_segment) {
        double value = std::numeric_limits<double>::quiet_NaN();
        for (unsigned int s = 0; s < errors.size(); ++s)
          value = std::fmax(value, std::abs(of_segment(s)));
        return value;
      };
      const double length = largest([&](const unsigned int s) {
        return errors[s].length / solve.measures[s].length;
      });
      const double radius = largest([&](const unsigned int s) {
        return errors[s].mid_radius / solve.measures[s].mid_radius;
      });
      const double pressure = largest([&](const unsigned int s) {
        return solve.segments[s].mean_pressure();
      });
      const double of_pressure =
        largest([&](const unsigned int s) { return errors[s].pressure; });
      const double place =
        largest([&](const unsigned int s) { return errors[s].position; });

      std::ostringstream parts;
      parts << std::setprecision(2);
      const auto add = [&](const std::string &name,
                           const double       value,
                           const std::string &unit) {
        if (std::isfinite(value))
          parts << (parts.str().empty() ? "" : ", ") << name << " " << value
                << unit;
      };
      add("length", 100. * length, "%");
      add("radius", 100. * radius, "%");
      if (pressure > 0.)
        add("pressure", 100. * of_pressure / pressure, "%");
      add("place", place, " mm");
      return parts.str().empty() ?
               "" :
               "        " + what + ", the largest of all segments: " +
                 parts.str() + "\n";
    }
  } // namespace



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
  log_errors(Log &log, const StepRecord &step)
  {
    const auto &solve = step.reports().back()->solves.back();
    log << line_of_errors("estimated errors", step.errors, solve)
        << line_of_errors("errors of steps", step.errors_of_steps, solve)
        << line_of_errors("errors of resets", step.errors_of_resets, solve);
  }



  void
  log_costs(Log &log, const RunCosts &costs)
  {
    std::ostringstream table;
    table << "\nWhere the time went" << std::setw(20) << "seconds"
          << std::setw(8) << "share" << std::setw(9) << "calls\n";
    const auto row = [&](const std::string &name, const double seconds) {
      table << "  " << std::left << std::setw(25) << name << std::right
            << std::fixed << std::setw(12) << std::setprecision(2) << seconds
            << std::setw(7) << std::setprecision(0)
            << 100. * seconds / costs.seconds << "%";
    };
    for (const RunCosts::Part &part : costs.parts)
      {
        row(part.name, part.seconds);
        table << std::setw(8) << part.n_calls << "\n";
        for (const RunCosts::Part &below : part.parts)
          {
            row("  " + below.name, below.seconds);
            table << std::setw(8) << below.n_calls << "\n";
          }
      }
    row("total", costs.seconds);
    table << "\nPeak memory of the largest rank: " << std::setprecision(0)
          << costs.peak_memory << " MB.\nMost iterations of a linear solve: "
          << costs.most_linear_iterations << ".\n";
    log << table.str();
  }
} // namespace lumbricus
