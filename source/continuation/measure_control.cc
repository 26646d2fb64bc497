// SPDX-License-Identifier: LGPL-2.1-or-later
#include "measure_control.h"

#include <lumbricus/core/exceptions.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/program/chain_model.h>
#include <lumbricus/program/run_watch.h>

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "clock.h"
#include "path_direction.h"
#include "path_equation.h"

namespace lumbricus
{
  namespace
  {
    // Values that differ by less than this part are alike.
    constexpr double alike = 1e-9;



    // m(u)/m_0 = l.
    class GivenMeasure : public PathEquation
    {
    public:
      GivenMeasure(ChainModel           &model,
                   const MeasureControl &control,
                   const double          at_rest,
                   const double          l)
        : PathEquation(model)
        , control(control)
        , at_rest(at_rest)
        , l(l)
      {}

      Equation
      equation(const Vector &solution, const double /*t*/) const override
      {
        const double m =
          control.value(model, model.space.with_ghosts(solution));
        return {m / at_rest - l,
                64. * std::numeric_limits<double>::epsilon() * (1. + l)};
      }

      Derivatives
      derivatives(const Vector &solution, const double /*t*/) const override
      {
        BorderVector by_u(
          control.derivative(model, model.space.with_ghosts(solution)));
        by_u.scale(1. / at_rest);
        return {by_u, 0.};
      }

    private:
      const MeasureControl &control;
      const double          at_rest, l;
    };
  } // namespace



  MeasureControl::MeasureControl(const std::string &section,
                                 const std::string &measure)
    : section(section)
    , measure(measure)
  {}



  void
  MeasureControl::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Segments",
                      segment_list,
                      "[numbers] Whose " + measure +
                        " is given, from 1 at the head: a list of numbers and "
                        "ranges as '1, 8-10', of which it is the sum.",
                      dealii::Patterns::Anything());
    prm.add_parameter("Relative " + measure,
                      target,
                      "[-] Where it goes to, relative to that at rest; there "
                      "the run ends. 'Time/End' is the most that its loads may "
                      "come to on the way.",
                      PositiveNumber());
    prm.add_parameter("Step",
                      largest,
                      "[-] The part of itself by which the " + measure +
                        " changes in a step, or less.",
                      PositiveNumber());
    prm.add_parameter("Smallest step",
                      smallest,
                      "[-] A step that does not converge is halved; the run "
                      "ends when it would be smaller than this.",
                      PositiveNumber());
    branch.declare_parameters(prm);
  }



  void
  MeasureControl::check_parameters() const
  {
    std::ostringstream what;
    what << "is " << smallest << ", more than 'Step', " << largest
         << ". Make it smaller.";
    AssertThrow(smallest <= largest, ExcParameter("Smallest step", what.str()));
  }



  void
  MeasureControl::initialize(const RunParameters &parameters)
  {
    of_segments = segments_in_list(path("Segments"),
                                   segment_list,
                                   parameters.anatomy.geometry().n_segments());
    AssertThrow(!of_segments.empty(),
                ExcInput(about_parameter(path("Segments"),
                                         "is empty. Name one at least.")));
  }



  void
  MeasureControl::open(const ChainModel &model)
  {
    Continuation::open(model);
    check_needs_no_clock(model);
    check(model);
  }



  void
  MeasureControl::refuse(const unsigned int segment,
                         const std::string &why) const
  {
    throw ExcInput(about_parameter(path("Segments"),
                                   "has segment " +
                                     std::to_string(segment + 1) + ", which " +
                                     why + "."));
  }



  std::string
  MeasureControl::name() const
  {
    return measure + " of segment" + (of_segments.size() > 1 ? "s " : " ") +
           segment_list;
  }



  std::string
  MeasureControl::path(const std::string &entry) const
  {
    return "Path/" + section + "/" + entry;
  }



  double
  MeasureControl::relative_value(const ChainModel &model,
                                 const Vector     &solution) const
  {
    Vector rest = solution;
    rest        = 0.;
    return value(model, model.space.with_ghosts(solution)) /
           value(model, model.space.with_ghosts(rest));
  }



  StepRecord
  MeasureControl::advance(ChainModel        &model,
                          State             &state,
                          const unsigned int number,
                          RunWatch          &watch,
                          Log               &log)
  {
    StepRecord step;
    step.number           = number;
    const auto relaxation = model.relax_liquid_mesh(state);
    if (!relaxation.in_segment.empty())
      step.relaxed = relaxation.in_segment;

    Vector rest = state.solution;
    rest        = 0.;
    const double at_rest = value(model, model.space.with_ghosts(rest));
    const double l       = relative_value(model, state.solution);
    const double way     = std::log(target / l);
    if (size == 0.)
      size = largest;
    while (true)
      {
        size = std::min(size, largest);
        // Do not leave a tiny step.
        const bool   is_last = std::abs(way) <= size * (1. + 1e-6);
        const double change  = is_last ? way : std::copysign(size, way);
        const double next_l  = is_last ? target : l * std::exp(change);

        const State::Past guess = predict(model, state, l, next_l);
        watch.begin_step(number, guess.time);
        try
          {
            GivenMeasure equation(model, *this, at_rest, next_l);
            State next = equation.solve(state, guess.solution, guess.time, step);
            check_loads(model, l, state, next.time);
            given = next_l;
            if (branch.is_looked_for())
              follow_a_branch(model, equation, state, next, step, log);
            step.time = next.time;
            step.size = next.time - state.time;
            if (!state.past.empty() &&
                step.size * (state.time - state.past.front().time) < 0.)
              log << "        the loads turn in this step, from where they go "
                  << (step.size < 0. ? "back" : "on") << "\n";
            state     = next;
            size      = step.n_cuts > 0 ? std::abs(change) :
                                          std::min(largest, 1.5 * size);
            if (finished(model, state))
              log << "        the " << name() << " is " << target
                  << " of that at rest at the time " << state.time << "\n";
            return step;
          }
        catch (const ExcNotConverged &exception)
          {
            ++step.n_cuts;
            cut(l, change, state, plain_message(exception), log);
          }
        // Newton's method may try a time for which the loads were not made.
        catch (const ExcInput &exception)
          {
            ++step.n_cuts;
            cut(l, change, state, plain_message(exception), log);
          }
      }
  }



  State::Past
  MeasureControl::predict(const ChainModel &model,
                          const State      &state,
                          const double      l,
                          const double      next_l) const
  {
    State::Past guess{state.time, state.solution};
    // Loads may begin with no slope, as t^2 does.
    if (guess.time == 0.)
      guess.time = model.parameters.load_stepping.first_step();
    if (state.past.empty())
      return guess;
    const State::Past &before = state.past.front();
    const double       last   = l - relative_value(model, before.solution);
    if (std::abs(last) > alike)
      {
        const double part = (next_l - l) / last;
        guess.solution.sadd(1. + part, -part, before.solution);
        guess.time += part * (state.time - before.time);
      }
    return guess;
  }



  void
  MeasureControl::follow_a_branch(ChainModel   &model,
                                  PathEquation &equation,
                                  const State  &state,
                                  State        &next,
                                  StepRecord   &step,
                                  Log          &log)
  {
    const auto distance = [&](const State &from, const State &to) {
      Vector way = to.solution;
      way -= from.solution;
      return PathMetric::mean_displacement(
        model.body, model.assembler.tangent().unknowns, way);
    };
    // Aside by as much as this step has moved the body.
    const State      main          = next;
    constexpr double smallest_part = 1. / 1024;
    const auto       aside         = branch.follow(
      model,
      [&]() { return equation.stability(main); },
      {1., smallest_part, 1. / distance(state, main)},
      state,
      next,
      step,
      log);
    if (!aside)
      return;
    // From there to where the measure is what it was to be, if that is not back on the
    // first branch.
    try
      {
        State on_branch =
          equation.solve(next, next.solution, next.time, step);
        on_branch.past = next.past;
        if (distance(main, on_branch) > 0.5 * distance(main, next))
          next = on_branch;
      }
    catch (const ExcNotConverged &)
      {
        ++step.n_cuts;
      }
    given = relative_value(model, next.solution);
  }



  void
  MeasureControl::check_loads(const ChainModel &model,
                              const double      l,
                              const State      &state,
                              const double      to) const
  {
    const double end = model.parameters.load_stepping.end_time();
    if (to >= -alike * end && to <= end * (1. + alike))
      return;
    std::ostringstream message;
    message << "The " << name() << " is " << l << " of that at rest at time "
            << state.time << ", and another step towards '"
            << path("Relative " + measure) << "' = " << target
            << " would need the loads of time " << to << ". ";
    if (to > end)
      message << "Raise 'Time/End', which is " << end
              << ", if they may become so large, or choose a value that is "
                 "nearer";
    else
      message << "The run's begin at 0, and from there on do the opposite. "
                 "Choose a value on the other side of 1, or let the loads act "
                 "the other way";
    AssertThrow(false, ExcSolveFailed(message.str() + "."));
  }



  void
  MeasureControl::cut(const double       l,
                      const double       change,
                      const State       &state,
                      const std::string &why,
                      Log               &log)
  {
    size = 0.5 * std::abs(change);
    if (size < smallest)
      {
        std::ostringstream message;
        message << "The " << name() << " does not get beyond " << l
                << " of that at rest, which it has at time " << state.time
                << ", with steps of '" << path("Smallest step")
                << "' = " << smallest << ". " << why
                << ". Perhaps no loads of this kind bring it to '"
                << path("Relative " + measure) << "' = " << target
                << ": choose a value that is nearer; or the " << measure
                << " turns back there along the path of equilibria: set "
                   "'Path/Control' to 'arc length'.";
        AssertThrow(false, ExcSolveFailed(message.str()));
      }
    log << "        cut to " << size << ": " << why << "\n";
  }



  bool
  MeasureControl::finished(const ChainModel & /*model*/,
                           const State & /*state*/) const
  {
    return std::abs(given / target - 1.) < alike;
  }



  Continuation::Numbers
  MeasureControl::numbers() const
  {
    Numbers numbers      = branch.numbers();
    numbers["given"]     = given;
    numbers["step_size"] = size;
    return numbers;
  }



  bool
  MeasureControl::set_numbers(const Numbers &numbers)
  {
    if (!has_same_names(numbers, this->numbers()) ||
        numbers.at("given") < 0. || numbers.at("step_size") < 0.)
      return false;
    branch.set_numbers(numbers);
    given = numbers.at("given");
    size  = numbers.at("step_size");
    return true;
  }
} // namespace lumbricus
