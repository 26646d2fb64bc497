// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_output_run_costs_h
#define lumbricus_output_run_costs_h

#include <lumbricus/linear/linear_solver.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /** Where the time of a run went since it was started, or restarted, and what
   * memory it took. */
  struct RunCosts
  {
    /** A part of the program. */
    struct Part
    {
      std::string  name;    ///< of the section, as in the log
      double       seconds; ///< wall time in it
      unsigned int n_calls; ///< how often it was entered
      /** Parts of it. */
      std::vector<Part> parts = {};
    };

    std::vector<Part> parts;           ///< the parts that were measured
    double            seconds     = 0; ///< of all
    double            peak_memory = 0; ///< of the largest rank [MB]
    unsigned int      most_linear_iterations = 0; ///< of one linear solve
  };

  /** What @p timer has measured in @p seconds, with what the linear solver
   * counted. Collective. */
  RunCosts
  run_costs(const dealii::TimerOutput    &timer,
            const double                  seconds,
            const LinearSolverStatistics &statistics,
            const MPI_Comm                comm);
} // namespace lumbricus

#endif
