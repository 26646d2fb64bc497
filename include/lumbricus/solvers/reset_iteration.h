// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_solvers_reset_iteration_h
#define lumbricus_solvers_reset_iteration_h

#include <lumbricus/discretization/segment_state.h>
#include <lumbricus/solvers/equilibrium.h>

#include <vector>

namespace lumbricus
{
  /**
   * The rubber-fluid reset (paper, "Coupling of liquid filling and elastic
   * membrane"): solve; where a segment's liquid diverges from the hydrostatic
   * state, make its present shape the stress-free one; solve again, until
   * every segment is hydrostatic. The solid keeps its stress.
   */
  class ResetIteration : public ParameterOwner
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    /** What one load step took. */
    struct Report
    {
      std::vector<std::vector<NewtonIteration>> newton;   ///< per solve
      std::vector<unsigned int>                 n_resets; ///< per segment
      /** Divergence per segment, after the last solve. */
      std::vector<double> divergence;

      unsigned int
      n_newton_iterations() const;
    };

    ResetMode
    mode() const;

    /** Solve for @p state at its time. Throws ExcNotConverged. Collective. */
    Report
    solve(State            &state,
          Equilibrium      &equilibrium,
          const Newton     &newton,
          ReferenceField   &references,
          const MixedSpace &space,
          const ShapeCache &shapes,
          const Anatomy    &anatomy) const;

  private:
    /** Make the present shape of the liquid stress-free in some segments. */
    void
    reset(State                   &state,
          const std::vector<bool> &in_segment,
          const MixedSpace        &space,
          const Anatomy           &anatomy) const;

    std::string  mode_name      = "isochoric";
    double       tolerance      = 1e-3;
    unsigned int limit          = 40;
    double       pressure_floor = 1e-6;
  };
} // namespace lumbricus

#endif
