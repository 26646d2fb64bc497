// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/contact/contacts.h>
#include <lumbricus/output/table.h>
#include <lumbricus/parameters/registry.h>

namespace lumbricus
{
  /** A row per load step, contact and segment that has skin there: what the
   * obstacle does to it. */
  class ContactTable : public Table
  {
  public:
    bool
    applies_to(const BoundaryConditions &conditions) const override
    {
      return has_contact(conditions);
    }

    std::vector<std::string>
    columns() const override
    {
      return {"t",
              "name",
              "segment",
              "normal_force",
              "force_x",
              "force_y",
              "force_z",
              "friction_x",
              "friction_y",
              "friction_z",
              "area",
              "penetration",
              "sliding",
              "anchored"};
    }

    void
    write(TableRows &rows, const OutputContext &context) const override
    {
      for (const ContactState &state : context.step.contacts)
        {
          rows << context.state.time << state.name << state.segment + 1
               << state.normal_force;
          for (const auto &vector : {state.force, state.friction})
            for (unsigned int c = 0; c < dim; ++c)
              rows << vector[c];
          rows << state.area << state.penetration << state.sliding_part()
               << state.is_anchored();
          rows.end_row();
        }
    }
  };

  static const Register<Table, ContactTable>
    contact_table("contact",
                  "every contact and segment, in runs that have a contact.");
} // namespace lumbricus
