// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_continuation_curve_samples_h
#define lumbricus_continuation_curve_samples_h

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace lumbricus
{
  /** The range of values that are numbers. */
  struct Range
  {
    /** The smallest. */
    double least = std::numeric_limits<double>::max();
    /** The largest. */
    double greatest = std::numeric_limits<double>::lowest();

    /** Take @p value in. */
    void
    add(const double value)
    {
      if (!std::isfinite(value))
        return;
      least    = std::min(least, value);
      greatest = std::max(greatest, value);
    }

    /** The largest minus the smallest. */
    double
    swing() const
    {
      return greatest > least ? greatest - least : 0.;
    }

    /** The largest of their sizes. */
    double
    size() const
    {
      return std::max(std::abs(least), std::abs(greatest));
    }
  };



  /** Values d of a function at sorted times t, those that are numbers. */
  struct Samples
  {
    /** Of @p value at @p times. */
    template <typename Value>
    Samples(const Value &value, const std::vector<double> &times)
    {
      for (const double at : times)
        {
          const double value_there = value(at);
          if (!std::isfinite(value_there))
            continue;
          t.push_back(at);
          d.push_back(value_there);
          range.add(value_there);
        }
    }

    /** How far inner sample @p i is beyond those at the ends: positive where
     * it is more than both, negative where it is less, else 0. */
    double
    excess(const std::size_t i) const
    {
      const auto [least, greatest] = std::minmax(d.front(), d.back());
      return d[i] > greatest ? d[i] - greatest :
             d[i] < least    ? d[i] - least :
                               0.;
    }

    /** The departure of @p value at time @p at from the straight line between
     * the ends. */
    double
    departure(const double at, const double value) const
    {
      const double part = (at - t.front()) / (t.back() - t.front());
      return value - (1. - part) * d.front() - part * d.back();
    }

    /** Whether inner sample @p i is beyond the ends by more than @p most and is
     * a peak, or the end of a level one. */
    bool
    is_peak_beyond(const std::size_t i, const double most) const
    {
      const double e    = excess(i);
      const double sign = e > 0. ? 1. : -1.;
      if (!(std::abs(e) > most && sign * (d[i] - d[i + 1]) > 0.))
        return false;
      std::size_t before = i;
      while (d[before] == d[i])
        --before;
      return sign * (d[i] - d[before]) > 0.;
    }

    /** The first of these; 0 for none. */
    std::size_t
    first_peak_beyond(const double most) const
    {
      for (std::size_t i = 1; i + 1 < t.size(); ++i)
        if (is_peak_beyond(i, most))
          return i;
      return 0;
    }

    std::vector<double> t;     ///< times
    std::vector<double> d;     ///< values
    Range               range; ///< of the values
  };



  /** The shortest interval between @p a and @p b that bisection finds to have
   * at least half of the change of @p value between them. */
  template <typename Value>
  std::pair<double, double>
  where_it_changes(const Value &value, const double a, const double b)
  {
    double       low = a, high = b, at_low = value(a), at_high = value(b);
    const double half = 0.5 * std::abs(at_high - at_low);
    while (true)
      {
        const double middle = 0.5 * (low + high);
        if (!(low < middle && middle < high) ||
            high - low < 1e-16 * std::abs(b))
          break;
        const double at_middle = value(middle);
        const bool   first =
          std::abs(at_middle - at_low) >= std::abs(at_high - at_middle);
        if (!(std::abs(first ? at_middle - at_low : at_high - at_middle) >=
              half))
          break;
        (first ? high : low)       = middle;
        (first ? at_high : at_low) = at_middle;
      }
    return {low, high};
  }



  /** The time between @p a and @p b at which @p value, with one peak there, is
   * largest, by golden sections; not worse than @p best. */
  template <typename Value>
  double
  where_largest(const Value &value, double a, double b, double best)
  {
    constexpr unsigned int n_sections = 60;

    const double ratio   = 0.5 * (std::sqrt(5.) - 1.);
    double       largest = value(best);
    double       x       = b - ratio * (b - a);
    double       y       = a + ratio * (b - a);
    double       at_x = value(x), at_y = value(y);
    for (unsigned int i = 0; i < n_sections; ++i)
      {
        for (const auto &[t, d] : {std::pair(x, at_x), std::pair(y, at_y)})
          if (d > largest)
            {
              best    = t;
              largest = d;
            }
        if (at_x >= at_y)
          {
            b    = y;
            y    = x;
            at_y = at_x;
            x    = b - ratio * (b - a);
            at_x = value(x);
          }
        else
          {
            a    = x;
            x    = y;
            at_x = at_y;
            y    = a + ratio * (b - a);
            at_y = value(y);
          }
      }
    return best;
  }
} // namespace lumbricus

#endif
