// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/output/table.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace lumbricus
{
  namespace
  {
    // A number of a segment, and its error.
    struct Number
    {
      const char *name;
      double SegmentError::*error;
      std::function<double(const ResetIteration::Solve &, const unsigned int)>
        value;
    };



    const std::vector<Number> &
    numbers()
    {
      using Solve = ResetIteration::Solve;
      static const std::vector<Number> all = {
        {"length",
         &SegmentError::length,
         [](const Solve &solve, const unsigned int s) {
           return solve.measures[s].length;
         }},
        {"mid_radius",
         &SegmentError::mid_radius,
         [](const Solve &solve, const unsigned int s) {
           return solve.measures[s].mid_radius;
         }},
        {"fluid_pressure",
         &SegmentError::pressure,
         [](const Solve &solve, const unsigned int s) {
           return solve.segments[s].mean_pressure();
         }},
        {"middle_x",
         &SegmentError::position,
         [](const Solve &solve, const unsigned int s) {
           return solve.measures[s].middle();
         }}};
      return all;
    }
  } // namespace



  /** A row per segment after the load steps that have an estimate: its length,
   * radius, pressure and place, each with its SegmentError of each kind. */
  class ErrorsTable : public Table
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("Errors",
                        every,
                        "[-] After every so many load steps estimate by how "
                        "much lengths, radii, pressures and places of segments "
                        "are off since cells are as large as they are, and "
                        "write that to errors.csv; 0 for never. Takes the time "
                        "of three or four load steps.",
                        dealii::Patterns::Integer(0));
      prm.add_parameter("Errors of steps",
                        of_steps,
                        "Estimate by how much they are off since steps in time "
                        "are as long as they are, where the body remembers "
                        "anything (friction, drag, pores, viscosity, "
                        "force-velocity), and write that to errors.csv after "
                        "about every other step: by the same run in steps twice "
                        "as long, which takes up to half as much time again.");
      prm.add_parameter("Errors of resets",
                        of_resets_every,
                        "[-] After every so many load steps estimate by how "
                        "much they are off since resets of the liquid end at "
                        "Reset/Tolerance, and write that to errors.csv, by two "
                        "resets more; 0 for never. The errors are 0 where "
                        "liquid flows, see Reset/Every.",
                        dealii::Patterns::Integer(0));
    }

    bool
    is_wanted() const override
    {
      return every > 0 || of_steps || of_resets_every > 0;
    }

    unsigned int
    steps_between_errors() const override
    {
      return every;
    }

    bool
    asks_for_errors_of_steps() const override
    {
      return of_steps;
    }

    bool
    asks_for_errors_of_resets(const unsigned int number) const override
    {
      return of_resets_every > 0 && number % of_resets_every == 0;
    }

    std::vector<std::string>
    columns() const override
    {
      std::vector<std::string> names = {"t", "segment"};
      for (const Number &number : numbers())
        {
          const std::string name = number.name;
          names.push_back(name);
          for (const Kind &kind : kinds())
            names.push_back(name + "_error" + kind.suffix);
        }
      return names;
    }

    void
    write(TableRows &rows, const OutputContext &context) const override
    {
      const StepRecord &step = context.step;
      const auto        all  = kinds();
      if (std::all_of(all.begin(), all.end(), [&](const Kind &kind) {
            return (step.*kind.errors).empty();
          }))
        return;
      const auto &solve = step.reports().back()->solves.back();
      for (unsigned int s = 0; s < solve.segments.size(); ++s)
        {
          rows << context.state.time << s + 1;
          for (const Number &number : numbers())
            {
              rows << number.value(solve, s);
              for (const Kind &kind : all)
                {
                  const auto &errors = step.*kind.errors;
                  rows << (errors.empty() ?
                             std::numeric_limits<double>::quiet_NaN() :
                             errors[s].*number.error);
                }
            }
          rows.end_row();
        }
    }

  private:
    /** Errors of one source, and what their columns end with. */
    struct Kind
    {
      std::string suffix;
      std::vector<SegmentError> StepRecord::*errors;
    };

    /** Those that are asked for. */
    std::vector<Kind>
    kinds() const
    {
      std::vector<Kind> kinds;
      if (every > 0)
        kinds.push_back({"", &StepRecord::errors});
      if (of_steps)
        kinds.push_back({"_of_steps", &StepRecord::errors_of_steps});
      if (of_resets_every > 0)
        kinds.push_back({"_of_resets", &StepRecord::errors_of_resets});
      return kinds;
    }

    unsigned int every           = 0;
    bool         of_steps        = false;
    unsigned int of_resets_every = 0;
  };

  static const Register<Table, ErrorsTable>
    errors_table("errors",
                 "lengths, radii, pressures and places of segments with their "
                 "estimated errors, where Errors, Errors of steps or Errors "
                 "of resets asks for them.");
} // namespace lumbricus
