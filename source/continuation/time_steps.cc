// SPDX-License-Identifier: LGPL-2.1-or-later
#include "time_steps.h"

#include <lumbricus/core/exceptions.h>
#include <lumbricus/parameters/registry.h>
#include <lumbricus/program/diagnosis.h>
#include <lumbricus/program/run_watch.h>

#include <algorithm>
#include <optional>
#include <sstream>

#include "load_path.h"

namespace lumbricus
{
  void
  TimeSteps::initialize(const RunParameters &parameters)
  {
    size = parameters.load_stepping.first_step();
    controllers.initialize(parameters.anatomy);
  }



  void
  TimeSteps::open(const ChainModel &model)
  {
    controllers.connect(model.triangulation.get_communicator());
  }



  StepRecord
  TimeSteps::advance(ChainModel        &model,
                     State             &state,
                     const unsigned int number,
                     RunWatch          &watch,
                     Log               &log)
  {
    const LoadStepping &stepping = model.parameters.load_stepping;
    const LoadCurves   &curves   = model.parameters.load_curves;
    StepRecord          step;
    step.number = number;
    size        = std::min({size,
                            stepping.largest_step(),
                            controllers.largest_step()});

    const auto relaxation = model.relax_liquid_mesh(state);
    if (!relaxation.in_segment.empty())
      step.relaxed = relaxation.in_segment;
    // Right before a jump.
    std::optional<double> stop;
    LoadCurves::Division  division{state.time, nullptr};
    bool                  again = false; // the same step once more
    while (true)
      {
        if (!again)
          division = plan_step(model, state, stop, log);
        again = false;
        // Beyond a corner or a jump nothing goes on as it did.
        const bool goes_on = division.curve == nullptr && !stop;
        try
          {
            take_step(model, state, step, division.to, watch);
            if (!goes_on)
              state.past.clear();
            return step;
          }
        catch (const ExcNotConverged &exception)
          {
            // Without extrapolation before a shorter step.
            if (!state.past.empty())
              {
                state.past.clear();
                again = true;
                continue;
              }
            const std::string why = plain_message(exception);
            ++step.n_cuts;
            const auto jump = curves.jump(state.time, division.to);
            if (!jump)
              {
                cut(model, state, division.to, why, log);
                continue;
              }
            if (jump->before.value_or(state.time) <=
                state.time + 0.5 * curves.shortest())
              {
                controllers.ask(model, state, jump->after);
                take_jump(model, *jump, state, step, watch, log);
                return step;
              }
            stop = jump->before;
            log << "        cut to before a jump: " << why << "\n";
          }
      }
  }



  LoadCurves::Division
  TimeSteps::plan_step(ChainModel                  &model,
                       const State                 &state,
                       const std::optional<double> &stop,
                       Log                         &log)
  {
    const double planned =
      model.parameters.load_stepping.next_time(state.time, size);
    auto division = model.parameters.load_curves.divide(state.time, planned);
    if (stop)
      division.to = std::min(division.to, *stop);
    else if (division.curve != nullptr)
      say_divided(division, planned, log);
    const double end = controllers.ask(model, state, division.to);
    // Before the corner.
    if (end < division.to)
      division = {end, nullptr};
    return division;
  }



  Continuation::Numbers
  TimeSteps::numbers() const
  {
    Numbers numbers      = controllers.numbers();
    numbers["step_size"] = size;
    return numbers;
  }



  bool
  TimeSteps::set_numbers(const Numbers &numbers)
  {
    if (numbers.count("step_size") == 0 || !(numbers.at("step_size") > 0.))
      return false;
    for (const auto &number : numbers)
      if (number.first != "step_size" && !Controllers::is_name(number.first))
        return false;
    if (!controllers.set_numbers(numbers))
      return false;
    size = numbers.at("step_size");
    return true;
  }



  void
  TimeSteps::take_step(ChainModel  &model,
                       State       &state,
                       StepRecord  &step,
                       const double to,
                       RunWatch    &watch)
  {
    const Predictor &predictor = model.parameters.predictor;
    State            next      = state;
    next.time                  = to;
    watch.begin_step(step.number, next.time);
    step.report = model.solve(next, next.time, predictor.predict(state, to));
    step.time   = next.time;
    step.size   = next.time - state.time;
    predictor.accept(state, next);
    state = next;
    size  = model.parameters.load_stepping.step_after(
      size, step.report.solves.front().newton.size());
  }



  void
  TimeSteps::take_jump(ChainModel             &model,
                       const LoadCurves::Jump &jump,
                       State                  &state,
                       StepRecord             &step,
                       RunWatch               &watch,
                       Log                    &log) const
  {
    const double from = state.time;
    watch.begin_step(step.number, jump.after);
    const LoadPathReport path = go_over(jump, model, state, log);
    step.report               = path.report;
    step.time                 = state.time;
    step.size                 = state.time - from;
    step.n_cuts += path.n_cuts;
    if (step.relaxed.empty())
      step.relaxed.resize(path.relaxed.size(), false);
    for (unsigned int s = 0; s < path.relaxed.size(); ++s)
      step.relaxed[s] = step.relaxed[s] || path.relaxed[s];
    state.past.clear();
  }



  void
  TimeSteps::cut(ChainModel        &model,
                 const State       &state,
                 const double       to,
                 const std::string &why,
                 Log               &log)
  {
    const LoadStepping &stepping = model.parameters.load_stepping;
    size                         = 0.5 * std::min(size, to - state.time);
    if (size < stepping.smallest_step())
      {
        std::ostringstream message;
        message << "No solution beyond time " << state.time
                << " with steps of 'Time/Smallest step' = "
                << stepping.smallest_step() << ". " << why << "."
                << diagnose(model, state, state.time, state.time + size);
        AssertThrow(false, ExcSolveFailed(message.str()));
      }
    log << "        cut to " << size << ": " << why << "\n";
  }



  void
  TimeSteps::say_divided(const LoadCurves::Division &division,
                         const double                planned,
                         Log                        &log)
  {
    if (!said_to_divide.insert(division.curve->what).second)
      return;
    std::ostringstream line;
    line << "        a step to time " << planned << " would miss a change of "
         << division.curve->what << division.curve->where
         << ":\n        this one ends at " << division.to
         << ", and others where they would.\n";
    log << line.str();
  }



  static const Register<Continuation, TimeSteps>
    time_steps("time",
               "load steps whose time is given, in section Time: as long as "
               "converge.");
} // namespace lumbricus
