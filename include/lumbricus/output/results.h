// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_output_results_h
#define lumbricus_output_results_h

#include <lumbricus/discretization/segment_state.h>
#include <lumbricus/output/cell_fields.h>
#include <lumbricus/output/csv_table.h>
#include <lumbricus/output/vtu_series.h>
#include <lumbricus/solvers/reset_iteration.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /** What a load step took. */
  struct StepRecord
  {
    explicit StepRecord(const unsigned int n_segments = 0);

    /** Take over what the reset iteration reports. */
    void
    take(const ResetIteration::Report &report);

    unsigned int number = 0;
    double       time   = 0.;
    double       size   = 0.;
    /** Tries that did not converge before this one did. */
    unsigned int n_cuts              = 0;
    unsigned int n_solves            = 0;
    unsigned int n_newton_iterations = 0;
    unsigned int n_linear_iterations = 0;
    unsigned int n_factorisations    = 0;
    double       seconds             = 0.;
    double       elapsed_seconds     = 0.;
    /** Per segment. */
    std::vector<unsigned int> n_resets;
    std::vector<double>       divergence;
  };



  /**
   * Everything a run leaves on disk: segments.csv and steps.csv with every
   * step, VTU files of some, and of the last good state in any case.
   */
  class Results
  {
  public:
    Results(const RunFolder      &folder,
            const MixedSpace     &space,
            const ShapeCache     &shapes,
            const Anatomy        &anatomy,
            const ReferenceField &references,
            const unsigned int    vtu_every);

    /** Write a state that has converged. Collective. */
    void
    write(const State &state, const StepRecord &step);

    /** Write the VTU files of @p state, which write() was called with last,
     * unless write() has done so. Collective. */
    void
    write_last(const State &state);

  private:
    const MixedSpace     &space;
    const ShapeCache     &shapes;
    const Anatomy        &anatomy;
    const ReferenceField &references;
    const unsigned int    vtu_every;

    CsvTable   segments;
    CsvTable   steps;
    VtuSeries  vtu;
    CellFields cell_fields;
    bool       vtu_is_current = false;
  };
} // namespace lumbricus

#endif
