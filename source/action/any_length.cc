// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/action/tension_curve.h>
#include <lumbricus/parameters/registry.h>

namespace lumbricus
{
  /** f_l = 1. */
  class AnyLength : public ForceLength
  {
  public:
    CurvePoint
    at(const double /*l*/) const override
    {
      return {1., 0.};
    }
  };



  static const Register<ForceLength, AnyLength>
    any_length("none", "all of it at any length.");
} // namespace lumbricus
