// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/output/table.h>
#include <lumbricus/parameters/registry.h>

#include <algorithm>

namespace lumbricus
{
  /** A row for the first mesh, and one per adaptation. */
  class MeshTable : public Table
  {
  public:
    std::vector<std::string>
    columns() const override
    {
      return {"step",
              "t",
              "cycle",
              "cells",
              "unknowns",
              "refined",
              "coarsened",
              "converged",
              "estimated_error",
              "volume_change",
              "pressure_change",
              "newton_iterations",
              "resets"};
    }

    void
    write(TableRows &rows, const OutputContext &context) const override
    {
      const StepRecord &step      = context.step;
      const auto        write_row = [&](const unsigned int      cycle,
                                 const AdaptationRecord &record) {
        const auto &n_resets = record.report.n_resets;
        rows << step.number << step.time << cycle << record.n_cells
             << record.n_unknowns << record.n_refined << record.n_coarsened
             << (record.converged || !record.any) << record.estimated_error
             << record.volume_change << record.pressure_change
             << record.report.n_newton_iterations()
             << (n_resets.empty() ?
                   0 :
                   *std::max_element(n_resets.begin(), n_resets.end()));
        rows.end_row();
      };

      if (step.number == 0)
        {
          AdaptationRecord at_first;
          at_first.n_cells =
            context.body.space.triangulation.n_global_active_cells();
          at_first.n_unknowns = context.body.space.dof_handler.n_dofs();
          at_first.converged  = true;
          write_row(0, at_first);
        }
      for (unsigned int cycle = 0; cycle < step.adaptations.size(); ++cycle)
        write_row(cycle + 1, step.adaptations[cycle]);
    }
  };

  static const Register<Table, MeshTable>
    mesh_table("mesh", "the first mesh and what adaptations did.");
} // namespace lumbricus
