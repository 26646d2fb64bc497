// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/geometry/ellipsoid_shells.h>

#include <cmath>

namespace lumbricus
{
  double
  EllipsoidShells::base_angle(const double depth) const
  {
    return std::acos(-base / long_radius(depth));
  }



  EllipsoidShells::Place
  EllipsoidShells::at(const double x, const double r) const
  {
    // Newton's method for (r/s)^2 + (x/l)^2 = 1: what is left falls with t and
    // is convex, so from the second iterate on t grows towards the root.
    double depth = 0.5;
    for (unsigned int i = 0; i < 50; ++i)
      {
        const double s = short_radius(depth), l = long_radius(depth);
        const double a = r / s * r / s, b = x / l * x / l;
        const double slope = -2. * (a / s * (short_out - short_in) +
                                    b / l * (long_out - long_in));
        const double step = (a + b - 1.) / slope;
        depth -= step;
        if (std::abs(step) < 1e-15)
          break;
      }
    return {depth,
            std::atan2(r / short_radius(depth), -x / long_radius(depth))};
  }
} // namespace lumbricus
