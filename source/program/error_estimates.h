// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_error_estimates_h
#define lumbricus_program_error_estimates_h

#include <lumbricus/core/log.h>
#include <lumbricus/errors/segment_error.h>
#include <lumbricus/program/chain_model.h>

#include <memory>
#include <vector>

#include "finer_model.h"

namespace lumbricus
{
  /**
   * Estimates what the mesh makes of the lengths, radii, pressures and places of segments:
   * how they would change with cells of half the size, to first order,
   *
   *   e = - K^(-1) r(P u),   error of J = J(P u + e) - J(u),
   *
   * with the residual r and the tangent K of the small cells, as far as FinerSolver
   * solves that. One solve is for all numbers of all segments.
   */
  class ErrorEstimates
  {
  public:
    /** For @p model, which is kept by reference. */
    explicit ErrorEstimates(ChainModel &model);

    /** Those of all segments at @p state, where the model has found @p solve; NaN,
     * with a word in @p log, where there is no estimate; NaN for places where the
     * skin remembers something. Collective. */
    std::vector<SegmentError>
    estimate(const State                 &state,
             const ResetIteration::Solve &solve,
             Log                         &log);

    /** The mesh has changed. */
    void
    reinit();

  private:
    ChainModel                 &model;
    std::unique_ptr<FinerModel> finer; ///< made when it is needed
  };
} // namespace lumbricus

#endif
