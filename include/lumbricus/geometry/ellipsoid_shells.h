// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_ellipsoid_shells_h
#define lumbricus_geometry_ellipsoid_shells_h

#include <lumbricus/core/dimension.h>

#include <deal.II/base/point.h>

namespace lumbricus
{
  /**
   * A wall of ellipsoids of revolution about the x axis, at depth t from 0
   * (inside) to 1 (outside), with angle theta from the apex at x < 0:
   *
   *   x = -l(t) cos theta,   r = s(t) sin theta,
   *   s = s_in + (s_out - s_in) t,   l = l_in + (l_out - l_in) t.
   */
  struct EllipsoidShells
  {
    /** A place in the plane through the axis. */
    struct Place
    {
      double depth; ///< t [-]
      double theta; ///< [radians]
    };

    double short_in  = 7.;  ///< s_in [mm]
    double short_out = 10.; ///< s_out [mm]
    double long_in   = 17.; ///< l_in [mm]
    double long_out  = 20.; ///< l_out [mm]
    double base      = 5.;  ///< the plane x = const that cuts them [mm]

    /** s(t) [mm]. */
    double
    short_radius(const double depth) const
    {
      return short_in + (short_out - short_in) * depth;
    }

    /** l(t) [mm]. */
    double
    long_radius(const double depth) const
    {
      return long_in + (long_out - long_in) * depth;
    }

    /** theta where the base cuts the ellipsoid of that depth. */
    double
    base_angle(const double depth) const;

    /** Where the point is at distance @p r from the axis, at @p x. */
    Place
    at(const double x, const double r) const;
  };



  /** A Geometry that has them. */
  class HasEllipsoidShells
  {
  public:
    virtual ~HasEllipsoidShells() = default;

    /** Its wall. */
    virtual const EllipsoidShells &
    shells() const = 0;
  };
} // namespace lumbricus

#endif
