// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/measures/external_forces.h>
#include <lumbricus/output/table.h>
#include <lumbricus/parameters/registry.h>

namespace lumbricus
{
  /**
   * A row for each load and support, and for their sum, after every load step:
   * the force and the moment about the origin that it has on the body.
   */
  class ReactionsTable : public Table
  {
  public:
    std::vector<std::string>
    columns() const override
    {
      return {"t",
              "kind",
              "name",
              "force_x",
              "force_y",
              "force_z",
              "moment_x",
              "moment_y",
              "moment_z"};
    }

    void
    write(TableRows &rows, const OutputContext &context) const override
    {
      const StepRecord &step = context.step;
      if (step.external_forces.empty())
        return;
      const auto write_row = [&](const std::string   &kind,
                                 const std::string   &name,
                                 const ExternalForce &entry) {
        rows << step.time << kind << name;
        for (unsigned int c = 0; c < dim; ++c)
          rows << entry.force[c];
        for (unsigned int c = 0; c < dim; ++c)
          rows << entry.moment[c];
        rows.end_row();
      };
      ExternalForce minimal_support, sum;
      bool          any = false;
      for (const ExternalForce &entry : step.external_forces)
        {
          sum += entry;
          if (entry.kind == ExternalForce::Kind::minimal_support)
            {
              minimal_support.kind = entry.kind;
              minimal_support.name = entry.name;
              minimal_support += entry;
              any = true;
            }
          else
            write_row(entry.kind_name(), entry.name, entry);
        }
      if (any)
        write_row(minimal_support.kind_name(),
                  minimal_support.name,
                  minimal_support);
      write_row("sum", "sum", sum);
    }
  };

  static const Register<Table, ReactionsTable>
    reactions_table("reactions", "the forces of all loads and supports.");
} // namespace lumbricus
