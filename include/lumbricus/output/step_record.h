// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_output_step_record_h
#define lumbricus_output_step_record_h

#include <lumbricus/equilibrium/reset_iteration.h>
#include <lumbricus/errors/segment_error.h>
#include <lumbricus/measures/body_motion.h>
#include <lumbricus/measures/contact_state.h>
#include <lumbricus/measures/external_forces.h>
#include <lumbricus/measures/step_work.h>

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
    bool        converged   = false;
    std::size_t n_cells     = 0; ///< active ones of the mesh after it
    std::size_t n_unknowns  = 0; ///< of the mesh after it
    std::size_t n_refined   = 0; ///< cells cut into eight
    std::size_t n_coarsened = 0; ///< cells made of eight
    /** See ErrorEstimate::relative; of the mesh before. */
    double estimated_error = 0.;
    /** The largest relative change of a liquid's or wall's volume, over the
     * segments. */
    double volume_change = 0.;
    /** The largest relative change of a liquid's mean pressure. */
    double pressure_change = 0.;
    /** Of solving again; empty where it did not converge. */
    ResetIteration::Report report;
  };



  /** What a load step took. */
  struct StepRecord
  {
    unsigned int number = 0;  ///< from 1; 0 is the state of rest
    double       time   = 0.; ///< State::time after it
    double       size   = 0.; ///< from the time before
    /** Tries that did not converge before this one did. */
    unsigned int n_cuts = 0;
    /** Iterations of the linear solver, those of failed tries included. */
    unsigned int n_linear_iterations = 0;
    /** Factorisations, those of failed tries included. */
    unsigned int n_factorisations = 0;
    /** What it took, with adaptation, but without output [s]. */
    double seconds = 0.;
    /** Since the run started, without the time between restarts [s]. */
    double elapsed_seconds = 0.;
    /** Of the softest motion, where that is watched [N/mm^4]. */
    double softest_stiffness = std::numeric_limits<double>::quiet_NaN();
    /** The segments inside whose liquid the mesh was relaxed before it; empty
     * for none. */
    std::vector<bool> relaxed;
    /** Of the load step; without solves for the state of rest. */
    ResetIteration::Report report;
    /** Of all loads and supports after it; empty for the state of rest. */
    std::vector<ExternalForce> external_forces;
    /** What obstacles do to each segment after it. */
    std::vector<ContactState> contacts;
    /** Where energy has come from and gone to; only where a table asks for
     * it. */
    StepWork work;
    /** Where the body is after it. */
    BodyMotion motion;
    /** The adaptations of the mesh after it. */
    std::vector<AdaptationRecord> adaptations;
    /** Of each segment, what the mesh makes, where a table asks for that; else
     * empty. */
    std::vector<SegmentError> errors;
    /** What steps in time make, in the same way. */
    std::vector<SegmentError> errors_of_steps;
    /** What the tolerance of the reset makes, in the same way. */
    std::vector<SegmentError> errors_of_resets;

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

    /** Whether the mesh inside the liquid of segment @p s was relaxed before it
     * or at its end. */
    bool
    is_relaxed(const unsigned int s) const
    {
      bool is = !relaxed.empty() && relaxed[s];
      for (const ResetIteration::Report *of_solves : reports())
        is = is || (!of_solves->relaxed.empty() && of_solves->relaxed[s]);
      return is;
    }
  };
} // namespace lumbricus

#endif
