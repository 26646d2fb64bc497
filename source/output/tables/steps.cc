// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/output/table.h>
#include <lumbricus/parameters/registry.h>

#include <cstddef>

namespace lumbricus
{
  /** A row per load step: what it took. */
  class StepsTable : public Table
  {
  public:
    std::vector<std::string>
    columns() const override
    {
      return {"step",
              "t",
              "dt",
              "cuts",
              "solves",
              "newton_iterations",
              "linear_iterations",
              "factorisations",
              "softest_stiffness",
              "seconds",
              "elapsed_seconds"};
    }

    void
    write(TableRows &rows, const OutputContext &context) const override
    {
      const StepRecord &step = context.step;
      std::size_t       n_solves = 0, n_newton_iterations = 0;
      for (const auto *report : step.reports())
        {
          n_solves += report->solves.size();
          n_newton_iterations += report->n_newton_iterations();
        }
      rows << step.number << step.time << step.size << step.n_cuts << n_solves
           << n_newton_iterations << step.n_linear_iterations
           << step.n_factorisations << step.softest_stiffness << step.seconds
           << step.elapsed_seconds;
      rows.end_row();
    }
  };

  static const Register<Table, StepsTable>
    steps_table("steps", "what every load step took.");
} // namespace lumbricus
