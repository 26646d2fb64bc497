// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/activation/held_values.h>

#include <algorithm>

namespace lumbricus
{
  double
  HeldValues::value(const double t, const unsigned int segment) const
  {
    const double v_a = way.before[segment - 1], v_b = way.after[segment - 1];
    // To the last bit at the ends.
    if (t >= way.to)
      return v_b;
    const double q = std::max(t - way.from, 0.) / (way.to - way.from);
    return (1. - q) * v_a + q * v_b;
  }



  void
  HeldValues::go_to(const double               from,
                    const double               to,
                    const std::vector<double> &values)
  {
    std::vector<double> before;
    for (unsigned int s = 1; s <= values.size(); ++s)
      before.push_back(value(from, s));
    way = {from, to, before, values};
  }
} // namespace lumbricus
