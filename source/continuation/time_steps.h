// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_continuation_time_steps_h
#define lumbricus_continuation_time_steps_h

#include <lumbricus/continuation/continuation.h>
#include <lumbricus/continuation/load_curves.h>

#include <optional>
#include <set>
#include <string>

#include "controllers.h"

namespace lumbricus
{
  /**
   * Steps whose time is given: t_(n+1) = t_n + h, with the h of LoadStepping,
   * or less so as to miss no change of the loads (LoadCurves). A step that does
   * not converge is cut; a jump is gone over in parts (go_over()). Newton's
   * method starts from what the Predictor says.
   */
  class TimeSteps : public Continuation
  {
  public:
    void
    initialize(const RunParameters &parameters) override;

    /** Connect to the controllers. */
    void
    open(const ChainModel &model) override;

    StepRecord
    advance(ChainModel        &model,
            State             &state,
            const unsigned int number,
            RunWatch          &watch,
            Log               &log) override;

    /** "step_size": of the load step wanted next [time]; and those of
     * Controllers. */
    Numbers
    numbers() const override;

    bool
    set_numbers(const Numbers &numbers) override;

  private:
    /** Where the next try of a step from @p state is to end: before time @p stop,
     * where there is one. Asks the controllers, see Controllers::ask(). */
    LoadCurves::Division
    plan_step(ChainModel                  &model,
              const State                 &state,
              const std::optional<double> &stop,
              Log                         &log);

    /** Try the load step of @p step from @p state to time @p to. Throws
     * ExcNotConverged. */
    void
    take_step(ChainModel  &model,
              State       &state,
              StepRecord  &step,
              const double to,
              RunWatch    &watch);

    /** Go over @p jump, right after @p state, in the load step of @p step.
     * Throws ExcSolveFailed. */
    void
    take_jump(ChainModel             &model,
              const LoadCurves::Jump &jump,
              State                  &state,
              StepRecord             &step,
              RunWatch               &watch,
              Log                    &log) const;

    /** Cut a step from @p state to time @p to, which did not converge for the
     * reason @p why. Throws ExcSolveFailed with a diagnosis. */
    void
    cut(ChainModel        &model,
        const State       &state,
        const double       to,
        const std::string &why,
        Log               &log);

    /** Say where the first step ends earlier than at time @p planned so as not
     * to miss a change of the datum of @p division. */
    void
    say_divided(const LoadCurves::Division &division,
                const double                planned,
                Log                        &log);

    /** The size of the step wanted next. */
    double size = 0.;

    Controllers controllers;

    /** Whose changes divide steps, of what that was said. */
    std::set<std::string> said_to_divide;
  };
} // namespace lumbricus

#endif
