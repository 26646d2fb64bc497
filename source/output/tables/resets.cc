// SPDX-License-Identifier: LGPL-2.1-or-later
#include "segment_columns.h"

#include <lumbricus/output/table.h>
#include <lumbricus/parameters/registry.h>

namespace lumbricus
{
  /** A row per solve and segment. */
  class ResetsTable : public Table
  {
  public:
    std::vector<std::string>
    columns() const override
    {
      return with_segment_columns({"t", "cycle", "reset", "segment"},
                                  {"largest_deviator"});
    }

    void
    write(TableRows &rows, const OutputContext &context) const override
    {
      const auto reports = context.step.reports();
      for (unsigned int cycle = 0; cycle < reports.size(); ++cycle)
        {
          const auto &solves = reports[cycle]->solves;
          for (unsigned int k = 0; k < solves.size(); ++k)
            for (unsigned int s = 0; s < solves[k].segments.size(); ++s)
              {
                rows << context.step.time << cycle << k << s + 1;
                add_segment(rows, solves[k], s);
                rows << solves[k].segments[s].largest_deviator;
                rows.end_row();
              }
        }
    }
  };

  static const Register<Table, ResetsTable>
    resets_table("resets", "every segment after every solve.");
} // namespace lumbricus
