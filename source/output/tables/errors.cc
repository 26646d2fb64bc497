// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/output/table.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/patterns.h>

namespace lumbricus
{
  /** A row per segment after the load steps that have an estimate: its length,
   * radius and pressure, each with its SegmentError. */
  class ErrorsTable : public Table
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("Errors",
                        every,
                        "[-] After every so many load steps estimate by how "
                        "much lengths, radii and pressures of segments are off "
                        "since cells are as large as they are, and write that "
                        "to errors.csv; 0 for never. Takes the time of "
                        "three or four load steps.",
                        dealii::Patterns::Integer(0));
    }

    bool
    is_wanted() const override
    {
      return every > 0;
    }

    unsigned int
    steps_between_errors() const override
    {
      return every;
    }

    std::vector<std::string>
    columns() const override
    {
      return {"t",
              "segment",
              "length",
              "length_error",
              "mid_radius",
              "mid_radius_error",
              "fluid_pressure",
              "fluid_pressure_error"};
    }

    void
    write(TableRows &rows, const OutputContext &context) const override
    {
      const StepRecord &step = context.step;
      if (step.errors.empty())
        return;
      const auto &solve = step.reports().back()->solves.back();
      for (unsigned int s = 0; s < step.errors.size(); ++s)
        {
          const SegmentError &error = step.errors[s];
          rows << context.state.time << s + 1 << solve.measures[s].length
               << error.length << solve.measures[s].mid_radius
               << error.mid_radius << solve.segments[s].mean_pressure()
               << error.pressure;
          rows.end_row();
        }
    }

  private:
    unsigned int every = 0;
  };

  static const Register<Table, ErrorsTable>
    errors_table("errors",
                 "lengths, radii and pressures of segments with their estimated "
                 "errors, where Errors asks for them.");
} // namespace lumbricus
