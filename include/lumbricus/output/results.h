// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_output_results_h
#define lumbricus_output_results_h

#include <lumbricus/checkpoint/run_progress.h>
#include <lumbricus/output/csv_table.h>
#include <lumbricus/output/output_parts.h>

#include <memory>
#include <vector>

namespace lumbricus
{
  /**
   * Everything a run leaves on disk: all tables with every step, pictures of
   * some steps, and of the last good state in any case.
   */
  class Results
  {
  public:
    /**
     * Claim tables and pictures in @p folder, before RunFolder::begin();
     * pictures follow every @p pictures_every steps, 0 for the last only.
     * Throws ExcInput for files in the folder that no run has written.
     * Collective.
     */
    Results(RunFolder                &folder,
            const Body               &body,
            const ReferenceField     &references,
            const LiquidWeight       &weight,
            const BoundaryConditions &conditions,
            OutputParts              &parts,
            const unsigned int        pictures_every);

    /** After every change of the mesh. Collective. */
    void
    reinit();

    /** Write a state that has converged. Collective. */
    void
    write(const State &state, const StepRecord &step);

    /** Write the picture of @p state, which write() was called with last,
     * unless write() has done so. Collective. */
    void
    write_last(const State &state);

    /** Note how far tables and pictures are in @p progress. */
    void
    note(RunProgress &progress) const;

    /** Go on where @p progress was noted; pictures of what came after are
     * removed. After RunFolder::begin(). Collective. */
    void
    continue_after(const RunProgress &progress);

  private:
    /** A table and its file. */
    struct TableOnDisk
    {
      Table                    *table;
      std::unique_ptr<CsvTable> file;
    };

    /** Write the picture of @p state, which the fields are of. */
    void
    write_picture(const State &state);

    const Body                body;
    const ReferenceField     &references;
    const LiquidWeight       &weight;
    const BoundaryConditions &conditions;
    OutputParts              &parts;
    const unsigned int        pictures_every;
    std::vector<TableOnDisk>  tables;
    CellFields                cell_fields;
    bool                      picture_is_current = false;
  };
} // namespace lumbricus

#endif
