// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_action_tension_curve_h
#define lumbricus_action_tension_curve_h

#include <lumbricus/core/curve_point.h>
#include <lumbricus/geometry/part_of_body.h>

namespace lumbricus
{
  /** Which part of its tension a fibre has at its length, with nothing else to
   * hold it back. */
  class ForceLength : public PartOfBody
  {
  public:
    /** f_l >= 0 at the stretch @p l = |F f| > 0 of the fibre. */
    virtual CurvePoint
    at(const double l) const = 0;
  };



  /** Which part of its tension a fibre has while its length changes. */
  class ForceVelocity : public PartOfBody
  {
  public:
    /** f_v >= 0, 1 at rest, at the rate @p v = dl/dt of the stretch [1/time],
     * less than zero while the fibre shortens. */
    virtual CurvePoint
    at(const double v) const = 0;

    /** Whether that is anything but 1. */
    virtual bool
    feels_speed() const
    {
      return true;
    }
  };
} // namespace lumbricus

#endif
