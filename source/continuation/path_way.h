// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_continuation_path_way_h
#define lumbricus_continuation_path_way_h

#include <lumbricus/core/state.h>
#include <lumbricus/output/step_record.h>
#include <lumbricus/program/chain_model.h>

#include <array>

#include "path_direction.h"

namespace lumbricus
{
  /**
   * The way along the path of equilibria on from a state: that of the step which led
   * there, (v, w), made as long as 1 by a PathMetric. All functions are collective.
   */
  class PathWay
  {
  public:
    /** On from @p state, which has a past; @p displacement is that of the metric.
     * Both are kept by reference. */
    PathWay(ChainModel &model, const State &state, const double displacement);

    /** Aside from @p state, in a direction @p aside in which the time does not
     * change at first. */
    PathWay(ChainModel   &model,
            const State  &state,
            const double  displacement,
            const Vector &aside);

    /** The change of the time in it, for a length of 1. */
    double
    by_time() const
    {
      return way.t;
    }

    /**
     * The state on the path in the plane
     *
     *   <(v, w), (u - u_n, t - t_n)> = s,
     *
     * where s is @p distance [time]; Newton's method starts at (u_n, t_n) +
     * s (v, w). Its past is the state here, its report goes to @p step. Throws
     * ExcNotConverged.
     */
    State
    step(const double distance, StepRecord &step) const;

    /** The state at time @p t instead, from that point of the way. Throws
     * ExcNotConverged. */
    State
    step_in_time(const double t, StepRecord &step) const;

    /** How stable the model is at the state here against motions across the way.
     * Throws ExcNotConverged. */
    Stability::Ends
    stability() const;

    /** How far @p next is from here [time]. */
    double
    length_to(const State &next) const;

    /** By which angle the way to @p next departs from this one [degree]. */
    double
    angle_to(const State &next) const;

    /** The highest or lowest time that the path comes to between the state before
     * and @p next, which is in the plane at @p distance: by parabolas through
     * points of the path and steps to where they turn, which are not kept. */
    double
    turning_time(const State &next, const double distance) const;

  private:
    /** In this direction, which is made as long as 1. */
    PathWay(ChainModel          &model,
            const State         &state,
            const double         displacement,
            const PathDirection &direction);

    /** From the state here to another. */
    PathDirection
    direction_to(const State &next) const;

    ChainModel      &model;
    const State     &state;
    const PathMetric metric;
    PathDirection    way;
    double           last_length; // before it was made 1
    Vector           row;
  };
} // namespace lumbricus

#endif
