// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_output_results_h
#define lumbricus_output_results_h

#include <lumbricus/checkpoint/run_progress.h>
#include <lumbricus/discretization/cell_fields.h>
#include <lumbricus/discretization/segment_state.h>
#include <lumbricus/output/csv_table.h>
#include <lumbricus/output/probes.h>
#include <lumbricus/output/step_record.h>
#include <lumbricus/output/vtu_series.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * Everything a run leaves on disk: segments.csv, resets.csv, points.csv,
   * reactions.csv, steps.csv, newton.csv and mesh.csv with every step, VTU
   * files of some steps, and of the last good state in any case.
   */
  class Results
  {
  public:
    /**
     * Claim tables and pictures in @p folder, before RunFolder::begin(); VTU
     * files follow every @p vtu_every steps, 0 for the last only. Throws
     * ExcInput for a probe point outside the body, and for files in the folder
     * that no run has written. Collective.
     */
    Results(RunFolder                             &folder,
            const MixedSpace                      &space,
            const ShapeCache                      &shapes,
            const Anatomy                         &anatomy,
            const ReferenceField                  &references,
            const std::vector<dealii::Point<dim>> &probe_points,
            const unsigned int                     vtu_every);

    /** After every change of the mesh. Collective. */
    void
    reinit();

    /** Write a state that has converged. Collective. */
    void
    write(const State &state, const StepRecord &step);

    /** Write the VTU files of @p state, which write() was called with last,
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
    /** What there is to say of the state of rest. */
    ResetIteration::Solve
    at_rest(const State &state) const;

    void
    write_segments(const State &state, const StepRecord &step);

    void
    write_resets(const StepRecord &step);

    void
    write_reactions(const StepRecord &step);

    void
    write_steps(const StepRecord &step);

    void
    write_newton(const StepRecord &step);

    void
    write_mesh(const StepRecord &step);

    const MixedSpace     &space;
    const ShapeCache     &shapes;
    const Anatomy        &anatomy;
    const ReferenceField &references;
    const unsigned int    vtu_every;

    CsvTable   segments;
    CsvTable   resets;
    CsvTable   reactions;
    CsvTable   steps;
    CsvTable   newton;
    CsvTable   mesh;
    CellFields cell_fields;
    VtuSeries  vtu;
    Probes     probes;
    bool       vtu_is_current = false;
  };
} // namespace lumbricus

#endif
