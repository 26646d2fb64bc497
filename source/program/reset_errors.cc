// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reset_errors.h"

#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/interruption.h>
#include <lumbricus/core/out_of_memory.h>

#include <cmath>
#include <limits>

namespace lumbricus
{
  namespace
  {
    using Solve = ResetIteration::Solve;

    // What more resets than those before the last of @p solves add to the number
    // value(solve, segment) of the first, and set it as @p error of all segments.
    template <typename Value>
    void
    set_errors(const std::vector<Solve>  &solves,
               const Value               &value,
               double SegmentError::     *error,
               std::vector<SegmentError> &errors)
    {
      const auto change = [&](const unsigned int k, const unsigned int s) {
        return value(solves[k], s) - value(solves[k - 1], s);
      };
      const auto largest_change = [&](const unsigned int k) {
        double largest = 0.;
        for (unsigned int s = 0; s < errors.size(); ++s)
          largest = std::fmax(largest, std::abs(change(k, s)));
        return largest;
      };
      const unsigned int last   = solves.size() - 1;
      const double       before = largest_change(last - 1);
      const double       after  = largest_change(last);
      const double       rest =
        after < before ? after / (before - after) : 0.; // q / (1 - q)
      for (unsigned int s = 0; s < errors.size(); ++s)
        errors[s].*error = value(solves[last], s) - value(solves[0], s) +
                           rest * change(last, s);
    }
  } // namespace



  std::vector<SegmentError>
  errors_of_resets(ChainModel                  &model,
                   const State                 &state,
                   const ResetIteration::Solve &solve,
                   Log                         &log)
  {
    std::vector<SegmentError> errors(solve.segments.size());
    if (model.liquid_flows())
      return errors;

    // What would be saved is the state before this step.
    const Uninterrupted        uninterrupted;
    dealii::TimerOutput::Scope scope(model.timer, "errors of resets");
    constexpr unsigned int     n_resets = 2;
    try
      {
        ResetIteration::Report more;
        with_memory_message(model.space.communicator(), [&]() {
          more = model.reset_again(state, n_resets);
        });
        // Where resets are turned off there are none.
        if (more.solves.size() <= n_resets)
          return errors;
        std::vector<Solve> solves = {solve};
        solves.insert(solves.end(), more.solves.begin() + 1, more.solves.end());
        set_errors(
          solves,
          [](const Solve &at, const auto s) { return at.measures[s].length; },
          &SegmentError::length,
          errors);
        set_errors(
          solves,
          [](const Solve &at, const auto s) {
            return at.measures[s].mid_radius;
          },
          &SegmentError::mid_radius,
          errors);
        set_errors(
          solves,
          [](const Solve &at, const auto s) {
            return at.segments[s].mean_pressure();
          },
          &SegmentError::pressure,
          errors);
        set_errors(
          solves,
          [](const Solve &at, const auto s) { return at.measures[s].middle(); },
          &SegmentError::position,
          errors);
      }
    catch (const dealii::ExceptionBase &exception)
      {
        if (!is_thrown_on_all_ranks(exception))
          throw;
        log << "        no errors of resets: " << plain_message(exception)
            << "\n";
        const double none = std::numeric_limits<double>::quiet_NaN();
        errors.assign(errors.size(), {none, none, none, none});
      }
    model.set_to(state);
    return errors;
  }
} // namespace lumbricus
