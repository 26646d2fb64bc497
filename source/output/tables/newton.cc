// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/output/table.h>
#include <lumbricus/parameters/registry.h>

namespace lumbricus
{
  /** A row per iteration of Newton's method. */
  class NewtonTable : public Table
  {
  public:
    std::vector<std::string>
    columns() const override
    {
      return {"step",
              "cycle",
              "solve",
              "iteration",
              "force_residual",
              "volume_residual",
              "increment",
              "step_length"};
    }

    void
    write(TableRows &rows, const OutputContext &context) const override
    {
      const StepRecord &step    = context.step;
      const auto        reports = step.reports();
      for (unsigned int cycle = 0; cycle < reports.size(); ++cycle)
        for (unsigned int k = 0; k < reports[cycle]->solves.size(); ++k)
          {
            unsigned int n = 0;
            for (const NewtonIteration &iteration :
                 reports[cycle]->solves[k].newton)
              {
                rows << step.number << cycle << k + 1 << ++n
                     << iteration.residual.force << iteration.residual.volume
                     << iteration.increment << iteration.step_length;
                rows.end_row();
              }
          }
    }
  };

  static const Register<Table, NewtonTable>
    newton_table("newton", "the residuals of every Newton iteration.");
} // namespace lumbricus
