// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_continuation_load_path_h
#define lumbricus_continuation_load_path_h

#include <lumbricus/continuation/load_curves.h>
#include <lumbricus/core/log.h>
#include <lumbricus/program/chain_model.h>

#include <vector>

namespace lumbricus
{
  /** What it took to go over a jump of the loads. */
  struct LoadPathReport
  {
    ResetIteration::Report report;      ///< of all parts, in their order
    unsigned int           n_parts = 0; ///< into which it was divided
    unsigned int           n_cuts  = 0; ///< parts that did not converge
    std::vector<bool>      relaxed;     ///< as StepRecord::relaxed
  };



  /**
   * Take @p state, which is in equilibrium, over @p jump to the time after it:
   * through the equilibria at
   *
   *   d(theta) = (1 - theta) d(t) + theta d(t_after),  0 < theta <= 1,
   *
   * with t the time of @p state, and d(t) that of rest where the jump has
   * nothing before it; the data d are all active stretches, loads and prescribed
   * displacements. Parts of theta are cut and grow as load steps do. Throws
   * ExcSolveFailed, with @p state as it was, where parts of 1/1024 do not
   * converge. Collective.
   */
  LoadPathReport
  go_over(const LoadCurves::Jump &jump,
          ChainModel             &model,
          State                  &state,
          Log                    &log);
} // namespace lumbricus

#endif
