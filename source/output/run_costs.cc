// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/output/run_costs.h>

#include <deal.II/base/utilities.h>

namespace lumbricus
{
  RunCosts
  run_costs(const dealii::TimerOutput    &timer,
            const double                  seconds,
            const LinearSolverStatistics &statistics,
            const MPI_Comm                comm)
  {
    RunCosts costs;
    costs.seconds = seconds;
    const auto calls = timer.get_summary_data(dealii::TimerOutput::n_calls);
    for (const auto &[name, of_part] :
         timer.get_summary_data(dealii::TimerOutput::total_wall_time))
      {
        costs.parts.push_back(
          {name, of_part, static_cast<unsigned int>(calls.at(name))});
        if (name == "linear solver")
          costs.parts.back().parts = {{"factorisation",
                                       statistics.factor_seconds,
                                       statistics.n_factorisations},
                                      {"iterations",
                                       statistics.solve_seconds,
                                       statistics.n_iterations}};
      }

    dealii::Utilities::System::MemoryStats memory;
    dealii::Utilities::System::get_memory_stats(memory);
    costs.peak_memory =
      dealii::Utilities::MPI::max(memory.VmHWM / 1024., comm);
    costs.most_linear_iterations = statistics.most_iterations;
    return costs;
  }
} // namespace lumbricus
