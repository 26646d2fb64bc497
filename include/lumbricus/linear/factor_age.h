// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_factor_age_h
#define lumbricus_linear_factor_age_h

#include <algorithm>
#include <cmath>

namespace lumbricus
{
  /**
   * When to factor again: as soon as the last solve cost more iterations
   * beyond what new factors would need than the average of all since the last
   * factorisation, its own cost included. That is where the average has its
   * minimum.
   */
  class FactorAge
  {
  public:
    /** A solve to the relative residual @p tolerance took these iterations. */
    void
    solved(const unsigned int n_iterations, const double tolerance)
    {
      const double decades = std::max(1., -std::log10(tolerance));
      if (n_solves++ == 0)
        per_decade = n_iterations / decades;
      excess = std::max(0., n_iterations - per_decade * decades);
      all_excess += excess;
    }

    /** @p cost_of_factors is that of a factorisation, in iterations. */
    bool
    worn_out(const double cost_of_factors) const
    {
      return n_solves > 0 && excess * n_solves > cost_of_factors + all_excess;
    }

  private:
    unsigned int n_solves   = 0;
    double       per_decade = 0.;
    double       excess     = 0.;
    double       all_excess = 0.;
  };
} // namespace lumbricus

#endif
