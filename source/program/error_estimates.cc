// SPDX-License-Identifier: LGPL-2.1-or-later
#include "error_estimates.h"

#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/interruption.h>
#include <lumbricus/core/out_of_memory.h>

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
        with_memory_message(model.space.communicator(), [&]() {
          if (finer == nullptr)
            finer = std::make_unique<FinerModel>(model,
                                                 FinerModel::Shape::true_one);
          errors = finer->errors(state, solve);
        });
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
