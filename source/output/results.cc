// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/output/results.h>

namespace lumbricus
{
  Results::Results(RunFolder                &folder,
                   const Body               &body,
                   const ReferenceField     &references,
                   const LiquidWeight       &weight,
                   const BoundaryConditions &conditions,
                   OutputParts              &parts,
                   const unsigned int        pictures_every)
    : body(body)
    , references(references)
    , weight(weight)
    , conditions(conditions)
    , parts(parts)
    , pictures_every(pictures_every)
    , cell_fields(body, references, weight, conditions, parts.field_arrays())
  {
    for (const auto &[name, table] : parts.tables())
      tables.push_back({table,
                        std::make_unique<CsvTable>(folder,
                                                   name,
                                                   table->columns(),
                                                   body.space.communicator())});
    parts.format().claim(folder);
    reinit();
  }



  void
  Results::reinit()
  {
    cell_fields.reinit();
    for (const TableOnDisk &entry : tables)
      entry.table->reinit(body.space);
  }



  void
  Results::write(const State &state, const StepRecord &step)
  {
    const OutputContext context(
      state, step, body, references, weight, cell_fields);
    for (const TableOnDisk &entry : tables)
      {
        entry.table->write(entry.file->rows(), context);
        // Without rows too: a restart goes on with every table.
        entry.file->flush();
      }

    picture_is_current =
      pictures_every > 0 && step.number % pictures_every == 0;
    if (picture_is_current)
      {
        context.fields();
        write_picture(state);
      }
  }



  void
  Results::write_picture(const State &state)
  {
    parts.format().write(state,
                         cell_fields,
                         obstacle_surfaces(body, conditions, state));
  }



  void
  Results::write_last(const State &state)
  {
    if (picture_is_current)
      return;
    cell_fields.update(state);
    write_picture(state);
    picture_is_current = true;
  }



  void
  Results::note(RunProgress &progress) const
  {
    for (const TableOnDisk &entry : tables)
      progress.tables.insert(entry.file->name_and_content());
    progress.format             = parts.format_name();
    progress.pictures           = parts.format().pictures();
    progress.picture_is_current = picture_is_current;
  }



  void
  Results::continue_after(const RunProgress &progress)
  {
    parts.format().continue_after(progress.pictures);
    picture_is_current = progress.picture_is_current;
  }
} // namespace lumbricus
