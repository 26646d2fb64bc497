// SPDX-License-Identifier: LGPL-2.1-or-later
#include "arc_length.h"

#include <lumbricus/core/exceptions.h>
#include <lumbricus/equilibrium/stability.h>
#include <lumbricus/parameters/registry.h>
#include <lumbricus/program/diagnosis.h>
#include <lumbricus/program/run_watch.h>

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include "clock.h"

namespace lumbricus
{
  namespace
  {
    // The part of the largest turn that steps aim at.
    constexpr double easy = 0.7;
  } // namespace



  void
  ArcLength::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Largest turn",
                      largest_turn,
                      "[degree] A step whose direction departs by more than "
                      "this from that of the step before is taken again, "
                      "shorter.",
                      dealii::Patterns::Double(1., 90.));
    prm.add_parameter("Length",
                      end_length,
                      "[time] The run ends where the path is as long as this, in "
                      "which the first step is 'Time/First step' long; 0: at "
                      "'Time/End', or at rest again.",
                      dealii::Patterns::Double(0.));
    branch.declare_parameters(prm);
  }



  void
  ArcLength::initialize(const RunParameters &parameters)
  {
    size     = parameters.load_stepping.first_step();
    smallest = parameters.load_stepping.smallest_step();
  }



  void
  ArcLength::open(const ChainModel &model)
  {
    Continuation::open(model);
    check_needs_no_clock(model);
  }



  StepRecord
  ArcLength::advance(ChainModel        &model,
                     State             &state,
                     const unsigned int number,
                     RunWatch          &watch,
                     Log               &log)
  {
    const LoadStepping &stepping = model.parameters.load_stepping;
    StepRecord          step;
    step.number           = number;
    const auto relaxation = model.relax_liquid_mesh(state);
    if (!relaxation.in_segment.empty())
      step.relaxed = relaxation.in_segment;

    std::optional<PathWay> way;
    if (!state.past.empty() && displacement > 0.)
      way.emplace(model, state, displacement);
    while (true)
      {
        size            = std::min(size, stepping.largest_step());
        const double to = state.time + size * (way ? way->by_time() : 1.);
        watch.begin_step(number, to);
        try
          {
            State next = way ? step_along(model, *way, to, step) :
                               first_step(model, state, to, step);
            if (way && !goes_on(*way, state, next, step, log))
              continue;
            if (branch.is_looked_for())
              follow_a_branch(model, state, next, step, log);
            step.time = next.time;
            step.size = next.time - state.time;
            state     = next;
            return step;
          }
        catch (const ExcNotConverged &exception)
          {
            ++step.n_cuts;
            cut(model, state, to, plain_message(exception), log);
          }
      }
  }



  State
  ArcLength::first_step(ChainModel  &model,
                        const State &state,
                        const double to,
                        StepRecord  &step)
  {
    State next  = state;
    next.time   = std::min(to, model.parameters.load_stepping.end_time());
    step.report = model.solve(next, next.time, state.solution);
    next.past   = {{state.time, state.solution}};

    Vector way = next.solution;
    way -= state.solution;
    const double mean =
      PathMetric::mean_displacement(model.body,
                                    model.assembler.tangent().unknowns,
                                    way);
    AssertThrow(mean > 0.,
                ExcSolveFailed("The body does not move in the first step along "
                               "its path. Raise 'Time/First step'."));
    length       = next.time - state.time;
    displacement = length / mean;
    return next;
  }



  State
  ArcLength::step_along(const ChainModel &model,
                        const PathWay    &way,
                        const double      to,
                        StepRecord       &step) const
  {
    // Where the run ends it does so at this time.
    const double end = model.parameters.load_stepping.end_time();
    return to > end || to < 0. ? way.step_in_time(to > end ? end : 0., step) :
                                 way.step(size, step);
  }



  void
  ArcLength::follow_a_branch(ChainModel  &model,
                             const State &state,
                             State       &next,
                             StepRecord  &step,
                             Log         &log)
  {
    const State    here = next;
    const PathWay  way(model, here, displacement);
    const auto     aside =
      branch.follow(model,
                    [&]() { return way.stability(); },
                    {size, smallest, displacement},
                    state,
                    next,
                    step,
                    log);
    length += aside.value_or(0.);
  }



  bool
  ArcLength::goes_on(const PathWay &way,
                     const State   &state,
                     const State   &next,
                     StepRecord    &step,
                     Log           &log)
  {
    const double angle = way.angle_to(next);
    const double part  = easy * largest_turn / std::max(angle, 1e-3);
    if (angle > largest_turn)
      {
        size *= std::max(0.25, part);
        ++step.n_cuts;
        log << "        cut to " << size << ": the path turns by " << angle
            << " degrees\n";
        AssertThrow(size >= smallest,
                    ExcNotConverged("The path turns by more than 'Path/arc "
                                    "length/Largest turn', however short a step "
                                    "is. Raise that where loads have corners"));
        return false;
      }
    if (way.by_time() * (next.time - state.time) < 0.)
      log << "        the path turns at the time "
          << way.turning_time(next, size) << ", from where it goes "
          << (way.by_time() > 0. ? "back" : "on") << "\n";
    length += way.length_to(next);
    size *= std::clamp(part, 0.5, step.n_cuts > 0 ? 1. : 1.5);
    return true;
  }



  void
  ArcLength::cut(ChainModel        &model,
                 const State       &state,
                 const double       to,
                 const std::string &why,
                 Log               &log)
  {
    const LoadStepping &stepping = model.parameters.load_stepping;
    size *= 0.5;
    if (size < stepping.smallest_step())
      {
        std::ostringstream message;
        message << "No solution beyond time " << state.time
                << " along the path, with steps of 'Time/Smallest step' = "
                << stepping.smallest_step() << ". " << why << "."
                << diagnose(model, state, state.time, to);
        AssertThrow(false, ExcSolveFailed(message.str()));
      }
    log << "        cut to " << size << ": " << why << "\n";
  }



  bool
  ArcLength::finished(const ChainModel &model, const State &state) const
  {
    return model.parameters.load_stepping.finished(state.time) ||
           (length > 0. && state.time <= 0.) ||
           (end_length > 0. && length >= end_length);
  }



  void
  ArcLength::adapted(State & /*state*/) const
  {}



  Continuation::Numbers
  ArcLength::numbers() const
  {
    Numbers numbers        = branch.numbers();
    numbers["length"]       = length;
    numbers["step_size"]    = size;
    numbers["displacement"] = displacement;
    return numbers;
  }



  bool
  ArcLength::set_numbers(const Numbers &numbers)
  {
    if (!has_same_names(numbers, this->numbers()) ||
        !(numbers.at("step_size") > 0.) ||
        numbers.at("length") < 0. || numbers.at("displacement") < 0.)
      return false;
    branch.set_numbers(numbers);
    length       = numbers.at("length");
    size         = numbers.at("step_size");
    displacement = numbers.at("displacement");
    return true;
  }



  static const Register<Continuation, ArcLength>
    arc_length("arc length",
               "steps along the path of equilibria, past limit points, where "
               "the load parameter turns back.");
} // namespace lumbricus
