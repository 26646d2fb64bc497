// SPDX-License-Identifier: LGPL-2.1-or-later
#include "double_steps.h"

#include <lumbricus/adaptivity/state_transfer.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/interruption.h>
#include <lumbricus/core/out_of_memory.h>
#include <lumbricus/discretization/state_beside.h>

#include <cmath>
#include <limits>

namespace lumbricus
{
  namespace
  {
    // What the long steps are, among State::globals.
    const std::string of_steps = "double_steps";



    // Sums over steps, of the length to the power of one more than the order.
    struct Sums
    {
      double of_short = 0.; // of the run
      double of_long  = 0.; // of the long steps
      double since    = 0.; // of the run, since the last long one has ended
      bool   lost     = false;
    };



    Sums
    sums_of(const State &state)
    {
      const auto &numbers = state.globals.at(of_steps);
      return {numbers[0], numbers[1], numbers[2], numbers[3] != 0.};
    }



    void
    set(State &state, const Sums &sums)
    {
      state.globals[of_steps] = {sums.of_short,
                                 sums.of_long,
                                 sums.since,
                                 sums.lost ? 1. : 0.};
    }
  } // namespace



  DoubleSteps::DoubleSteps(ChainModel &model, const bool wanted)
    : model(model)
    , wanted(wanted)
  {}



  void
  DoubleSteps::begin(State &state) const
  {
    if (!wanted || !model.order_of_steps())
      return;
    put_beside(model.space, without_state_beside(state), state);
    set(state, Sums());
  }



  void
  DoubleSteps::check(const Checkpoint &checkpoint, const State &state) const
  {
    const bool has_them = checkpoint.progress().globals.count(of_steps) > 0;
    AssertThrow(has_them == (state.globals.count(of_steps) > 0),
                ExcParameter("Output/Errors of steps",
                             "has to be as it was where the run began, '" +
                               std::string(has_them ? "true" : "false") +
                               "': the checkpoint '" + checkpoint.path() +
                               "' has " + (has_them ? "" : "no ") +
                               "steps twice as long to go on with."));
  }



  std::string
  DoubleSteps::note() const
  {
    return wanted && !model.order_of_steps() ?
             "Steps in time add no errors: nothing in this run remembers how it "
             "came to where it is.\n" :
             "";
  }



  std::vector<SegmentError>
  DoubleSteps::errors(State                       &state,
                      const ResetIteration::Solve &solve,
                      Log                         &log)
  {
    if (!wanted)
      return {};
    std::vector<SegmentError> errors(solve.segments.size());
    const auto                order = model.order_of_steps();
    if (!order)
      return errors;
    const auto set_to_none = [&errors]() {
      const double none = std::numeric_limits<double>::quiet_NaN();
      errors.assign(errors.size(), {none, none, none, none});
    };

    // What would be saved is the state before this step.
    const Uninterrupted        uninterrupted;
    dealii::TimerOutput::Scope scope(model.timer, "errors of steps");
    Sums                       sums = sums_of(state);
    if (sums.lost)
      {
        set_to_none();
        return errors;
      }
    const double power = *order + 1.;
    sums.since += std::pow(state.time - state.last_time, power);
    const double long_step =
      std::pow(state.time - time_beside(state), power);
    constexpr double enough = 0.75;
    const double     wished = std::pow(2., double(*order)) - 1.;
    if (long_step < (1. + enough * wished) * sums.since)
      {
        set(state, sums);
        return {};
      }

    sums.of_short += sums.since;
    sums.of_long += long_step;
    sums.since = 0.;
    try
      {
        ResetIteration::Solve worse;
        with_memory_message(model.space.communicator(),
                            [&]() { worse = take_step(state); });
        const double factor = sums.of_short / (sums.of_long - sums.of_short);
        for (unsigned int s = 0; s < errors.size(); ++s)
          errors[s] = {
            factor * (solve.measures[s].length - worse.measures[s].length),
            factor *
              (solve.measures[s].mid_radius - worse.measures[s].mid_radius),
            factor * (solve.segments[s].mean_pressure() -
                      worse.segments[s].mean_pressure()),
            factor * (solve.measures[s].middle() - worse.measures[s].middle())};
      }
    catch (const dealii::ExceptionBase &exception)
      {
        if (!is_thrown_on_all_ranks(exception))
          throw;
        log << "        no errors of steps from here on, since steps twice as "
               "long do not lead here: "
            << plain_message(exception) << "\n";
        sums.lost = true;
        set_to_none();
      }
    set(state, sums);
    // As after the step of the run.
    model.set_to(state);
    return errors;
  }



  ResetIteration::Solve
  DoubleSteps::take_step(State &state)
  {
    State start = state_beside(model.space, state);
    start.time  = state.time;
    make_conforming(model.space, start);
    model.relax_liquid_mesh(start);
    State                  beside = start;
    ResetIteration::Report report;
    bool                   converged = true;
    try
      {
        // Where the run is, the long steps are nearly.
        report = model.solve(beside, beside.time, state.solution);
      }
    catch (const ExcNotConverged &)
      {
        converged = false;
      }
    if (!converged)
      {
        beside = start;
        report = model.solve(beside);
      }
    model.end_step(beside);
    put_beside(model.space, beside, state);
    return report.solves.back();
  }
} // namespace lumbricus
