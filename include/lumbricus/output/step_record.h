// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_output_step_record_h
#define lumbricus_output_step_record_h

#include <lumbricus/solvers/reset_iteration.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace lumbricus
{
  /** What an adaptation of the mesh did. */
  struct AdaptationRecord
  {
    /** Whether any cell was to be changed. */
    bool any = false;
    /** Whether there was equilibrium on the new mesh; if not, the old one is
     * kept. */
    bool converged = false;
    /** Of the mesh after it. */
    std::size_t n_cells    = 0;
    std::size_t n_unknowns = 0;
    /** Cells cut into eight, and cells made of eight. */
    std::size_t n_refined   = 0;
    std::size_t n_coarsened = 0;
    /** See ErrorEstimate::relative; of the mesh before. */
    double estimated_error = 0.;
    /** The largest relative change of a liquid's or wall's volume, and of a
     * liquid's pressure, over the segments. */
    double volume_change   = 0.;
    double pressure_change = 0.;
    /** Of solving again; empty where it did not converge. */
    ResetIteration::Report report;
  };



  /** What a load step took. */
  struct StepRecord
  {
    unsigned int number = 0;
    double       time   = 0.;
    double       size   = 0.;
    /** Tries that did not converge before this one did. */
    unsigned int n_cuts              = 0;
    unsigned int n_linear_iterations = 0;
    unsigned int n_factorisations    = 0;
    double       seconds             = 0.;
    double       elapsed_seconds     = 0.;
    /** Of the softest motion, where that is watched [N/mm^4]. */
    double softest_stiffness = std::numeric_limits<double>::quiet_NaN();
    /** The segments inside whose liquid the mesh was relaxed before it; empty
     * for none. */
    std::vector<bool> relaxed;
    /** Of the load step; without solves for the state of rest. */
    ResetIteration::Report report;
    /** The adaptations of the mesh after it. */
    std::vector<AdaptationRecord> adaptations;

    /** The reports of all solves there were, in their order. */
    std::vector<const ResetIteration::Report *>
    reports() const
    {
      std::vector<const ResetIteration::Report *> all = {&report};
      for (const AdaptationRecord &adaptation : adaptations)
        if (adaptation.converged)
          all.push_back(&adaptation.report);
      return all;
    }
  };
} // namespace lumbricus

#endif
