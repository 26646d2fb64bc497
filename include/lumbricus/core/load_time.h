// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_load_time_h
#define lumbricus_core_load_time_h

#include <optional>

namespace lumbricus
{
  /**
   * When loads are taken, and with them active stretches and prescribed
   * displacements, all of which are data d(t): at a time, or a part theta of
   * the way from the data of one time to those of another,
   *
   *   d = (1 - theta) d(t_from) + theta d(t_to),
   *
   * which is how a jump is gone over. In place of a time to come from there may
   * be rest, without any loads.
   */
  class LoadTime
  {
  public:
    /** At time @p t. Implicit: a time is what this is nearly always. */
    LoadTime(const double t = 0.)
      : end(t)
    {}

    /** The part @p theta, more than 0 and at most 1, of the way from the data
     * at time @p from, or from rest where there is none, to those at @p to. */
    static LoadTime
    between(const std::optional<double> &from,
            const double                 to,
            const double                 theta)
    {
      LoadTime time(to);
      time.start = from;
      time.theta = theta;
      return time;
    }

    /** The time it is, or that the way leads to. */
    double
    to() const
    {
      return end;
    }

    /**
     * The datum whose values over time are @p value, a function of one double,
     * and which is @p at_rest where nothing acts. At a time this is value(t)
     * itself, to the last bit.
     */
    template <typename Function>
    double
    take(const Function &value, const double at_rest) const
    {
      const double there = value(end);
      if (theta == 1.)
        return there;
      const double here = start ? value(*start) : at_rest;
      return (1. - theta) * here + theta * there;
    }

  private:
    std::optional<double> start;
    double                end;
    double                theta = 1.;
  };
} // namespace lumbricus

#endif
