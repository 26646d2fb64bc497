// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/measures/step_work.h>
#include <lumbricus/output/table.h>
#include <lumbricus/parameters/registry.h>

namespace lumbricus
{
  /** Where energy comes from and goes in every load step: a row for the work of
   * each muscle, load and support, for what friction takes of that in each
   * contact, for what each viscous tissue dissipates, for what is stored, and for
   * the balance of all but friction. */
  class EnergyTable : public Table
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("Energy",
                        wanted,
                        "Whether the work of muscles, loads, friction and "
                        "viscosity in every load step is written to "
                        "energy.csv.");
    }

    bool
    is_wanted() const override
    {
      return wanted;
    }

    bool
    asks_for_work() const override
    {
      return wanted;
    }

    std::vector<std::string>
    columns() const override
    {
      return {"t", "kind", "name", "work"};
    }

    void
    write(TableRows &rows, const OutputContext &context) const override
    {
      const StepWork &work = context.step.work;
      const auto write_row = [&](const std::string &kind,
                                 const std::string &name,
                                 const double       value) {
        rows << context.step.time << kind << name << value;
        rows.end_row();
      };
      if (context.step.number == 0)
        return;
      for (const StepWork::Entry &muscle : work.muscles)
        write_row("muscle", muscle.name, muscle.work);
      for (const ExternalForce &load : work.loads)
        if (load.kind != ExternalForce::Kind::symmetry &&
            load.kind != ExternalForce::Kind::minimal_support)
          write_row(load.kind_name(), load.name, load.work);
      for (const StepWork::Entry &contact : work.friction)
        write_row("friction", contact.name, contact.work);
      for (const StepWork::Entry &tissue : work.viscosity)
        write_row("viscosity", tissue.name, tissue.work);
      if (!context.step.adaptations.empty())
        write_row("adaptation", "mesh", work.remeshed);
      write_row("stored", "tissues", work.stored_more);
      write_row("balance", "balance", work.imbalance());
    }

  private:
    bool wanted = false;
  };

  static const Register<Table, EnergyTable>
    energy_table("energy", "where energy comes from and goes, by 'Energy'.");
} // namespace lumbricus
