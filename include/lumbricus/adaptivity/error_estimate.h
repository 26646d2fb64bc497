// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_adaptivity_error_estimate_h
#define lumbricus_adaptivity_error_estimate_h

#include <lumbricus/adaptivity/error_estimator.h>
#include <lumbricus/output/cell_fields.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /** Where the error of a solution is, as far as its flux G tells. */
  struct ErrorEstimate
  {
    /**
     * Of each locally owned cell, in the order of iteration,
     *
     *   eta_K^2 = 1/2 sum_F h_F / (2 p) int_F |[G N]|^2 dA,
     *
     * over its faces F inside the body of diameter h_F, p = 2 [N^2/mm].
     */
    std::vector<double> eta_squared;
    /** sqrt(sum eta_K^2 / int |G|^2 dV) over the body: an estimate of the
     * relative error of G. */
    double relative = 0.;
  };



  /** The fields that estimate_errors() needs. */
  std::vector<std::string>
  fields_for_estimate();

  /** Estimate the error of the solution that @p fields are of, which have to
   * have fields_for_estimate(). Collective. */
  ErrorEstimate
  estimate_errors(const ErrorEstimator &estimator, const CellFields &fields);
} // namespace lumbricus

#endif
