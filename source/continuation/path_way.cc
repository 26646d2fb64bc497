// SPDX-License-Identifier: LGPL-2.1-or-later
#include "path_way.h"

#include <lumbricus/core/exceptions.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "path_equation.h"

namespace lumbricus
{
  namespace
  {
    // The plane in which a step ends.
    class Plane : public PathEquation
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
        : PathEquation(model)
        , metric(metric)
        , state(state)
        , row(row)
        , by_time(by_time)
        , distance(distance)
      {}

      Equation
      equation(const Vector &solution, const double t) const override
      {
        PathDirection way{solution, t - state.time};
        way.u -= state.solution;
        return {(metric.product(row, by_time, way) - distance) / unit(),
                8. * std::numeric_limits<double>::epsilon() *
                  (1. + std::abs(t) / unit())};
      }

      // The same everywhere: it is a plane.
      Derivatives
      derivatives(const Vector & /*solution*/,
                  const double /*t*/) const override
      {
        BorderVector by_u(row);
        by_u.scale(1. / unit());
        return {by_u, 0.5 * by_time / unit()};
      }

    private:
      const PathMetric &metric;
      const State      &state;
      const Vector     &row;
      const double      by_time, distance;
    };



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



    // From the state before to @p state.
    PathDirection
    last_way(const State &state)
    {
      const State::Past &before = state.past.front();
      PathDirection      way{state.solution, state.time - before.time};
      way.u -= before.solution;
      return way;
    }
  } // namespace



  PathWay::PathWay(ChainModel          &model,
                   const State         &state,
                   const double         displacement,
                   const PathDirection &direction)
    : model(model)
    , state(state)
    , metric(model.body, model.assembler.tangent().unknowns, displacement)
    , way(direction)
    , last_length(metric.length(way))
  {
    way.u *= 1. / last_length;
    way.t /= last_length;
    row = metric.row(way.u);
  }



  PathWay::PathWay(ChainModel  &model,
                   const State &state,
                   const double displacement)
    : PathWay(model, state, displacement, last_way(state))
  {}



  PathWay::PathWay(ChainModel   &model,
                   const State  &state,
                   const double  displacement,
                   const Vector &aside)
    : PathWay(model, state, displacement, PathDirection{aside, 0.})
  {}



  State
  PathWay::step(const double distance, StepRecord &step) const
  {
    Plane  plane(model, metric, state, row, way.t, distance);
    Vector guess = state.solution;
    guess.add(distance, way.u);
    return plane.solve(state, guess, state.time + distance * way.t, step);
  }



  State
  PathWay::step_in_time(const double t, StepRecord &step) const
  {
    State  next  = state;
    Vector guess = state.solution;
    guess.add((t - state.time) / way.t, way.u);
    next.time   = t;
    step.report = model.solve(next, t, guess);
    next.past   = {{state.time, state.solution}};
    return next;
  }



  Stability::Ends
  PathWay::stability() const
  {
    return Plane(model, metric, state, row, way.t, 0.).stability(state);
  }



  PathDirection
  PathWay::direction_to(const State &next) const
  {
    PathDirection direction{next.solution, next.time - state.time};
    direction.u -= state.solution;
    return direction;
  }



  double
  PathWay::length_to(const State &next) const
  {
    return metric.length(direction_to(next));
  }



  double
  PathWay::angle_to(const State &next) const
  {
    const PathDirection taken = direction_to(next);
    const double        cosine =
      metric.product(row, way.t, taken) / metric.length(taken);
    return std::acos(std::clamp(cosine, -1., 1.)) * 180. / dealii::numbers::PI;
  }



  double
  PathWay::turning_time(const State &next, const double distance) const
  {
    std::array<PathPoint, 3> points{
      {{-last_length, state.time - last_length * way.t},
       {0., state.time},
       {distance, next.time}}};
    PathPoint              turn      = vertex(points);
    constexpr unsigned int most      = 8;
    constexpr double       tolerance = 1e-7;
    try
      {
        for (unsigned int i = 0; i < most && std::isfinite(turn.s); ++i)
          {
            StepRecord   not_kept;
            const double t    = step(turn.s, not_kept).time;
            const double miss = std::abs(t - turn.t);
            if (miss < tolerance * std::abs(t))
              return t;
            // It takes the place of the one that is farthest away.
            std::sort(points.begin(),
                      points.end(),
                      [&](const PathPoint &p, const PathPoint &q) {
                        return std::abs(p.s - turn.s) < std::abs(q.s - turn.s);
                      });
            points[2] = {turn.s, t};
            turn      = vertex(points);
          }
      }
    catch (const ExcNotConverged &)
      {}
    return std::isfinite(turn.t) ? turn.t : points[2].t;
  }
} // namespace lumbricus
