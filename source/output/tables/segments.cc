// SPDX-License-Identifier: LGPL-2.1-or-later
#include "segment_columns.h"

#include <lumbricus/measures/mesh_quality.h>
#include <lumbricus/measures/section_measures.h>
#include <lumbricus/output/table.h>
#include <lumbricus/parameters/registry.h>

namespace lumbricus
{
  namespace
  {
    // What there is to say of the state of rest.
    ResetIteration::Solve
    at_rest(const OutputContext &context)
    {
      const Body  &body     = context.body;
      const Vector relevant = body.space.with_ghosts(context.state.solution);
      ResetIteration::Solve solve;
      solve.segments  = segment_states(
        body, context.references, relevant, context.state.globals);
      solve.measures  = section_measures(body, relevant);
      solve.qualities = mesh_qualities(body, &relevant);
      solve.divergence.assign(solve.segments.size(), 0.);
      return solve;
    }
  } // namespace



  /** A row per load step and segment: its shape, volumes and pressure. */
  class SegmentsTable : public Table
  {
  public:
    std::vector<std::string>
    columns() const override
    {
      return with_segment_columns({"t", "segment"},
                                  {"resets",
                                   "fluid_mesh_quality",
                                   "wall_mesh_quality",
                                   "relaxed"});
    }

    void
    write(TableRows &rows, const OutputContext &context) const override
    {
      const StepRecord           &step    = context.step;
      const auto                  reports = step.reports();
      const ResetIteration::Solve solve   = reports.back()->solves.empty() ?
                                              at_rest(context) :
                                              reports.back()->solves.back();
      for (unsigned int s = 0; s < solve.segments.size(); ++s)
        {
          unsigned int n_resets = 0;
          for (const auto *report : reports)
            n_resets += report->solves.empty() ? 0 : report->n_resets[s];
          rows << context.state.time << s + 1;
          add_segment(rows, solve, s);
          rows << n_resets << solve.qualities[s].liquid
               << solve.qualities[s].wall
               << step.is_relaxed(s);
          rows.end_row();
        }
    }
  };

  static const Register<Table, SegmentsTable>
    segments_table("segments", "every segment after every load step.");
} // namespace lumbricus
