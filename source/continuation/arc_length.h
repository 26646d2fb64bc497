// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_continuation_arc_length_h
#define lumbricus_continuation_arc_length_h

#include <lumbricus/continuation/continuation.h>

#include <array>

#include "path_direction.h"

namespace lumbricus
{
  /**
   * Steps along the path of equilibria, wherever it leads: past limit points, where
   * the load parameter t turns. With the way (v, w) of the last step, made as long as
   * 1 by a PathMetric, a step of length s ends in the plane
   *
   *   <(v, w), (u - u_n, t - t_n)> = s
   *
   * (Keller 1977, "Numerical solution of bifurcation and nonlinear eigenvalue
   * problems"; Riks 1979). Newton's method starts at (u_n, t_n) + s (v, w). Where
   * a step turns by more than 'Largest turn' it is taken again, shorter; that angle
   * says how long the next one is, and not how many iterations there were, which
   * hang on rounding. The first step is one in time.
   */
  class ArcLength : public Continuation
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    void
    initialize(const RunParameters &parameters) override;

    /** Throws ExcInput where something depends on how fast time goes, or a
     * prescribed displacement changes. */
    void
    open(const ChainModel &model) override;

    StepRecord
    advance(ChainModel        &model,
            State             &state,
            const unsigned int number,
            RunWatch          &watch,
            Log               &log) override;

    /** At 'Time/End', at rest again, or at the end of 'Length'. */
    bool
    finished(const ChainModel &model, const State &state) const override;

    /** The way goes on. */
    void
    adapted(State &state) const override;

    /** "length": of the path so far; "step_size": of the step wanted next
     * [time]; "displacement": the T/U of PathMetric [time/mm], 0 before the first
     * step. */
    Numbers
    numbers() const override;

    bool
    set_numbers(const Numbers &numbers) override;

  private:
    /** The first step, and one to a time at which the run ends. Throws
     * ExcNotConverged. */
    State
    step_in_time(ChainModel   &model,
                 const State  &state,
                 const double  to,
                 const Vector &guess,
                 StepRecord   &step) const;

    /** One as long as @p distance in direction @p way, with the metric's row of
     * that. Throws ExcNotConverged. */
    State
    step_along(ChainModel          &model,
               const State         &state,
               const PathDirection &way,
               const Vector        &row,
               const double         distance,
               StepRecord          &step) const;

    /** The highest or lowest time that the path comes to near @p state, between
     * three points of the @p times that are at these @p distances from there: by
     * parabolas and steps to where they turn, which are not kept. */
    double
    turning_time(ChainModel                  &model,
                 const State                 &state,
                 const PathDirection         &way,
                 const Vector                &row,
                 const std::array<double, 3> &times,
                 const std::array<double, 3> &distances) const;

    /** A step did not converge for the reason @p why: shorten the next. Throws
     * ExcSolveFailed. */
    void
    cut(ChainModel        &model,
        const State       &state,
        const double       to,
        const std::string &why,
        Log               &log);

    double largest_turn = 20.;
    double end_length   = 0.;

    double length       = 0.;
    double size         = 0.;
    double displacement = 0.;
  };
} // namespace lumbricus

#endif
