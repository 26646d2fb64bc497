// SPDX-License-Identifier: LGPL-2.1-or-later
#include "error_estimates.h"

#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/interruption.h>
#include <lumbricus/core/out_of_memory.h>
#include <lumbricus/discretization/state_beside.h>

#include <limits>

namespace lumbricus
{
  ErrorEstimates::ErrorEstimates(ChainModel &model)
    : model(model)
  {}



  void
  ErrorEstimates::reinit()
  {
    finer.reset();
  }



  std::vector<SegmentError>
  ErrorEstimates::estimate(const State                 &state,
                           const ResetIteration::Solve &solve,
                           Log                         &log)
  {
    // What would be saved is the state before this step.
    const Uninterrupted        uninterrupted;
    dealii::TimerOutput::Scope scope(model.timer, "error estimates");
    std::vector<SegmentError>  errors(solve.segments.size());
    const double               none = std::numeric_limits<double>::quiet_NaN();
    try
      {
        ResetIteration::Solve better;
        with_memory_message(model.space.communicator(), [&]() {
          if (finer == nullptr)
            finer = std::make_unique<FinerModel>(model);
          better = finer->measure(without_state_beside(state));
        });
        // Where the skin hangs on to something the body is where all steps before
        // have brought it, which one increment does not know.
        const bool knows_place = model.surface_terms.histories().empty();
        for (unsigned int s = 0; s < errors.size(); ++s)
          errors[s] = {better.measures[s].length - solve.measures[s].length,
                       better.measures[s].mid_radius -
                         solve.measures[s].mid_radius,
                       better.segments[s].mean_pressure() -
                         solve.segments[s].mean_pressure(),
                       knows_place ? better.measures[s].middle() -
                                       solve.measures[s].middle() :
                                     none};
      }
    catch (const dealii::ExceptionBase &exception)
      {
        // An expression without a value at a new point, a cell that folds, too
        // little memory for so many cells.
        if (!is_thrown_on_all_ranks(exception))
          throw;
        log << "        no estimate of errors: " << plain_message(exception)
            << "\n";
        reinit();
        errors.assign(errors.size(), {none, none, none, none});
      }
    return errors;
  }
} // namespace lumbricus
