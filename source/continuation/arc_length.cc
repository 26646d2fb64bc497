// SPDX-License-Identifier: LGPL-2.1-or-later
#include "arc_length.h"

#include <lumbricus/core/exceptions.h>
#include <lumbricus/discretization/displacement_before.h>
#include <lumbricus/equilibrium/load_unknown.h>
#include <lumbricus/parameters/registry.h>
#include <lumbricus/program/diagnosis.h>
#include <lumbricus/program/run_watch.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>
#include <deal.II/base/patterns.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

namespace lumbricus
{
  namespace
  {
    // The plane in which a step ends.
    class Plane : public LoadUnknown
    {
    public:
      // From @p state as far as @p distance in the direction whose row and change
      // of the load these are.
      Plane(ChainModel       &model,
            const PathMetric &metric,
            const State      &state,
            const Vector     &row,
            const double      by_time,
            const double      distance)
        : model(model)
        , metric(metric)
        , state(state)
        , row(row)
        , by_time(by_time)
        , distance(distance)
        , unit(model.parameters.load_stepping.first_step())
      {}

      void
      set_loads(const LoadTime &t) override
      {
        model.references.update_muscles(t);
        model.liquid_weight.set_time(t);
      }

      double
      difference() const override
      {
        return 1e-6 * unit;
      }

      Equation
      equation(const Vector &solution, const double t) const override
      {
        PathDirection way{solution, t - state.time};
        way.u -= state.solution;
        return {(metric.product(row, by_time, way) - distance) / unit,
                8. * std::numeric_limits<double>::epsilon() *
                  (1. + std::abs(t) / unit),
                scaled_row(),
                0.5 * by_time / unit};
      }

    private:
      BorderVector
      scaled_row() const
      {
        BorderVector scaled(row);
        scaled.scale(1. / unit);
        return scaled;
      }

      ChainModel       &model;
      const PathMetric &metric;
      const State      &state;
      const Vector     &row;
      const double      by_time, distance, unit;
    };



    // The equilibrium solves for the load parameter as long as this is there.
    class WithUnknownLoad
    {
    public:
      WithUnknownLoad(Equilibrium &equilibrium, LoadUnknown &load)
        : equilibrium(equilibrium)
      {
        equilibrium.set_load_unknown(&load);
      }

      ~WithUnknownLoad()
      {
        equilibrium.set_load_unknown(nullptr);
      }

      WithUnknownLoad(const WithUnknownLoad &) = delete;
      WithUnknownLoad &
      operator=(const WithUnknownLoad &) = delete;

    private:
      Equilibrium &equilibrium;
    };



    // The part of the largest turn that steps aim at.
    constexpr double easy = 0.7;



    // A point of the path: how far it is along the way, and the load there.
    struct PathPoint
    {
      double s, t;
    };



    // Where the parabola through three points turns.
    PathPoint
    vertex(const std::array<PathPoint, 3> &points)
    {
      const auto &[a, b, c]  = points;
      const double slope_ab  = (b.t - a.t) / (b.s - a.s);
      const double slope_bc  = (c.t - b.t) / (c.s - b.s);
      const double curvature = (slope_bc - slope_ab) / (c.s - a.s);
      const double slope     = slope_ab + curvature * (b.s - a.s);
      const double s         = -0.5 * slope / curvature;
      return {b.s + s, b.t + 0.5 * slope * s};
    }



    // Whether what it prescribes changes over the time of the run, in the middle of
    // some face. Collective.
    bool
    moves(const NamedCondition &condition, const ChainModel &model)
    {
      const auto *prescribed = condition.prescribed_displacement();
      if (prescribed == nullptr)
        return false;
      const auto times = model.parameters.times_to_try();
      const auto known = prescribed->components();
      bool       any   = false;
      for (const auto &cell : model.space.owned_cells())
        for (const unsigned int f : cell->face_indices())
          if (cell->face(f)->at_boundary() &&
              cell->face(f)->boundary_id() == condition.boundary)
            for (unsigned int c = 0; c < dim; ++c)
              for (const double t : times)
                any = any ||
                      (known[c] &&
                       prescribed->value(c, cell->face(f)->center(), t) !=
                         prescribed->value(c, cell->face(f)->center(), times[0]));
      return dealii::Utilities::MPI::logical_or(any, model.space.communicator());
    }



    void
    refuse(const std::string &what, const std::string &instead)
    {
      AssertThrow(false,
                  ExcInput(about_parameter("Path/Control",
                                           "is 'arc length', along which time "
                                           "may go back, but " +
                                             what + ". " + instead)));
    }
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
  }



  void
  ArcLength::initialize(const RunParameters &parameters)
  {
    size = parameters.load_stepping.first_step();
  }



  void
  ArcLength::open(const ChainModel &model)
  {
    Continuation::open(model);
    const BoundaryConditions &conditions = model.parameters.boundary_conditions;
    for (unsigned int i = 0; i < conditions.n_conditions(); ++i)
      {
        const auto *term = conditions.condition(i).surface_term();
        if (term != nullptr && term->depends_on_rate())
          refuse("'Boundary conditions/" + conditions.condition(i).name +
                   "' depends on how fast the body moves",
                 "Leave it out, or set 'time'");
      }
    if (model.surface_terms.may_slide())
      refuse("the skin slides with friction, which remembers the way in time",
             "Set its friction to 0, or set 'time'");
    if (muscles_feel_speed(model.parameters.anatomy))
      refuse("a muscle feels how fast it shortens",
             "Set its 'Force-velocity' to 'none', or set 'time'");
    if (model.parameters.cavity_contents.exchange().any())
      refuse("liquid flows through pores, leaks or in from outside",
             "Close them, or set 'time'");
    for (unsigned int i = 0; i < conditions.n_conditions(); ++i)
      if (moves(conditions.condition(i), model))
        refuse("'Boundary conditions/" + conditions.condition(i).name +
                 "' prescribes displacements that change",
               "Prescribe a load, or set 'time'");
  }



  StepRecord
  ArcLength::advance(ChainModel        &model,
                     State             &state,
                     const unsigned int number,
                     RunWatch          &watch,
                     Log               &log)
  {
    const LoadStepping &stepping = model.parameters.load_stepping;
    const CellUnknowns &unknowns = model.assembler.tangent().unknowns;
    StepRecord          step;
    step.number           = number;
    const auto relaxation = model.relax_liquid_mesh(state);
    if (!relaxation.in_segment.empty())
      step.relaxed = relaxation.in_segment;

    const bool          begins = state.past.empty() || displacement == 0.;
    PathDirection       way{state.solution, size};
    double              last_distance = 0.;
    Vector              row;
    const PathMetric    metric(model.body,
                            unknowns,
                            begins ? 1. : displacement);
    if (begins)
      way.u = 0.;
    else
      {
        const State::Past &before = state.past.front();
        way.u -= before.solution;
        way.t                = state.time - before.time;
        last_distance        = metric.length(way);
        way.u *= 1. / last_distance;
        way.t /= last_distance;
        row = metric.row(way.u);
      }

    while (true)
      {
        size             = std::min(size, stepping.largest_step());
        const double to  = state.time + size * (begins ? 1. : way.t);
        watch.begin_step(number, to);
        try
          {
            // Where the run ends it does so at this time.
            const bool ends = to > stepping.end_time() || (to < 0. && !begins);
            State      next = state;
            if (begins || ends)
              {
                const double last =
                  begins ? std::min(to, stepping.end_time()) :
                           std::clamp(to, 0., stepping.end_time());
                Vector guess = state.solution;
                if (!begins)
                  guess.add((last - state.time) / way.t, way.u);
                next = step_in_time(model, state, last, guess, step);
              }
            else
              next = step_along(model, state, way, row, size, step);

            PathDirection taken{next.solution, next.time - state.time};
            taken.u -= state.solution;
            if (begins)
              {
                const double mean =
                  PathMetric::mean_displacement(model.body, unknowns, taken.u);
                AssertThrow(mean > 0.,
                            ExcSolveFailed("The body does not move in the first "
                                           "step; raise 'Time/First step'"));
                displacement = taken.t / mean;
                length       = taken.t;
                state        = next;
                step.time    = state.time;
                step.size    = taken.t;
                return step;
              }
            const double distance = metric.length(taken);
            const double turn =
              std::acos(std::clamp(metric.product(row, way.t, taken) / distance,
                                   -1.,
                                   1.)) *
              180. / dealii::numbers::PI;
            if (turn > largest_turn && !ends &&
                0.5 * size > stepping.smallest_step())
              {
                size *= std::max(0.25, easy * largest_turn / turn);
                ++step.n_cuts;
                log << "        cut to " << size << ": the path turns by "
                    << turn << " degrees\n";
                continue;
              }
            if (way.t * taken.t < 0.)
              log << "        the path turns at the time "
                  << turning_time(model,
                                  state,
                                  way,
                                  row,
                                  {{state.time - last_distance * way.t,
                                    state.time,
                                    next.time}},
                                  {{-last_distance, 0., size}})
                  << ", from where it goes " << (way.t > 0. ? "back" : "on")
                  << "\n";
            length += distance;
            size *= std::clamp(easy * largest_turn / std::max(turn, 1e-3),
                               0.5,
                               step.n_cuts > 0 ? 1. : 1.5);
            step.time = next.time;
            step.size = taken.t;
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
  ArcLength::step_in_time(ChainModel   &model,
                          const State  &state,
                          const double  to,
                          const Vector &guess,
                          StepRecord   &step) const
  {
    State next  = state;
    next.time   = to;
    step.report = model.solve(next, to, guess);
    next.past   = {{state.time, state.solution}};
    return next;
  }



  State
  ArcLength::step_along(ChainModel          &model,
                        const State         &state,
                        const PathDirection &way,
                        const Vector        &row,
                        const double         distance,
                        StepRecord          &step) const
  {
    const PathMetric metric(model.body,
                            model.assembler.tangent().unknowns,
                            displacement);
    Plane            plane(model, metric, state, row, way.t, distance);
    State            next  = state;
    Vector           guess = state.solution;
    guess.add(distance, way.u);
    next.time                       = state.time + distance * way.t;
    next.globals[LoadUnknown::name] = {next.time};
    {
      const WithUnknownLoad with_load(model.equilibrium, plane);
      step.report = model.solve(next, next.time, guess);
    }
    next.time = next.globals.at(LoadUnknown::name)[0];
    next.globals.erase(LoadUnknown::name);
    next.past = {{state.time, state.solution}};
    return next;
  }



  double
  ArcLength::turning_time(ChainModel                  &model,
                          const State                 &state,
                          const PathDirection         &way,
                          const Vector                &row,
                          const std::array<double, 3> &times,
                          const std::array<double, 3> &distances) const
  {
    std::array<PathPoint, 3> points;
    for (unsigned int i = 0; i < 3; ++i)
      points[i] = {distances[i], times[i]};
    PathPoint              turn      = vertex(points);
    constexpr unsigned int most      = 8;
    constexpr double       tolerance = 1e-7;
    try
      {
        for (unsigned int i = 0; i < most; ++i)
          {
            StepRecord   step;
            const double t =
              step_along(model, state, way, row, turn.s, step).time;
            const double miss = std::abs(t - turn.t);
            // It takes the place of the one that is farthest away.
            std::sort(points.begin(),
                      points.end(),
                      [&](const PathPoint &p, const PathPoint &q) {
                        return std::abs(p.s - turn.s) < std::abs(q.s - turn.s);
                      });
            points[2] = {turn.s, t};
            turn      = vertex(points);
            if (miss < tolerance * std::abs(t))
              return t;
            if (!std::isfinite(turn.s))
              return points[0].t;
          }
      }
    catch (const ExcNotConverged &)
      {}
    return turn.t;
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
    return {{"length", length},
            {"step_size", size},
            {"displacement", displacement}};
  }



  bool
  ArcLength::set_numbers(const Numbers &numbers)
  {
    if (numbers.size() != 3 || numbers.count("length") == 0 ||
        numbers.count("step_size") == 0 || numbers.count("displacement") == 0 ||
        !(numbers.at("step_size") > 0.) || numbers.at("length") < 0. ||
        numbers.at("displacement") < 0.)
      return false;
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
