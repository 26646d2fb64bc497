// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/action/tension_curve.h>
#include <lumbricus/parameters/registry.h>

namespace lumbricus
{
  /** f_v = 1. */
  class AnySpeed : public ForceVelocity
  {
  public:
    CurvePoint
    at(const double /*v*/) const override
    {
      return {1., 0.};
    }

    bool
    feels_speed() const override
    {
      return false;
    }
  };



  static const Register<ForceVelocity, AnySpeed>
    any_speed("none", "all of it at any speed.");
} // namespace lumbricus
