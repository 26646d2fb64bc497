// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_continuation_arc_length_h
#define lumbricus_continuation_arc_length_h

#include <lumbricus/continuation/continuation.h>

#include "branching.h"
#include "path_way.h"

namespace lumbricus
{
  /**
   * Steps along the path of equilibria, wherever it leads: past limit points, where
   * the load parameter t turns: each ends in a plane across the way of the last one,
   * see PathWay (Keller 1977, "Numerical solution of bifurcation and nonlinear
   * eigenvalue problems"; Riks 1979). Where a step turns by more than 'Largest
   * turn' it is taken again, shorter; that angle says how long the next one is, and
   * not how many iterations there were, which hang on rounding. The first step is
   * one in time.
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
     * step; and those of Branching. */
    Numbers
    numbers() const override;

    /** Where the loads turn. */
    bool
    time_may_go_back() const override
    {
      return true;
    }

    bool
    set_numbers(const Numbers &numbers) override;

  private:
    /** The first step, to time @p to, which the metric is made by. Throws
     * ExcNotConverged. */
    State
    first_step(ChainModel  &model,
               const State &state,
               const double to,
               StepRecord  &step);

    /** One as long as is wanted, or to the end of the run if that comes first:
     * @p to is the time expected. Throws ExcNotConverged. */
    State
    step_along(const ChainModel &model,
               const PathWay    &way,
               const double      to,
               StepRecord       &step) const;

    /** Say how long the step after the one from @p state to @p next is to be, and
     * whether the path turns back.
     * @return whether it is to be kept; if not it has to be shorter. */
    bool
    goes_on(const PathWay &way,
            const State   &state,
            const State   &next,
            StepRecord    &step,
            Log           &log);

    /** Where the step from @p state to @p next has passed a bifurcation: put a state
     * of the other branch into @p next. Throws ExcNotConverged. */
    void
    follow_a_branch(ChainModel  &model,
                    const State &state,
                    State       &next,
                    StepRecord  &step,
                    Log         &log);

    /** A step did not converge for the reason @p why: shorten the next. Throws
     * ExcSolveFailed. */
    void
    cut(ChainModel        &model,
        const State       &state,
        const double       to,
        const std::string &why,
        Log               &log);

    double      largest_turn = 20.;
    double      end_length   = 0.;
    Branching   branch;
    double      smallest = 0.;

    double length       = 0.;
    double size         = 0.;
    double displacement = 0.;
  };
} // namespace lumbricus

#endif
