// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_load_curve_h
#define lumbricus_core_load_curve_h

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace lumbricus
{
  /** A datum over time, at some points of the body: an active stretch, a load,
   * a prescribed displacement. The same on all ranks. */
  struct LoadCurve
  {
    /** What it is, for messages: "the active stretch of muscle 'circular'". All
     * that has this name is measured by the same swing. */
    std::string what;
    /** Where, for messages: " in segment 2"; may be empty. */
    std::string where;
    /** The value of the curve where nothing acts. */
    double at_rest = 0.;
    /** Its value over time, at each of the points. */
    std::vector<std::function<double(double)>> values;
    /** The times between two that have to be looked at, where samples could
     * miss them; may be empty. */
    std::function<std::vector<double>(double, double)> marks;
  };



  /** So few of @p all, evenly spread, that to look at them takes no time. */
  template <typename T>
  std::vector<T>
  some_of(const std::vector<T> &all, const std::size_t most)
  {
    std::vector<T>    some;
    const std::size_t n = std::min(most, all.size());
    for (std::size_t i = 0; i < n; ++i)
      some.push_back(all[(2 * i + 1) * all.size() / (2 * n)]);
    return some;
  }
} // namespace lumbricus

#endif
