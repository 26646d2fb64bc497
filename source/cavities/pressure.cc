// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/parameters/registry.h>

#include <optional>

#include "given_content.h"

namespace lumbricus
{
  /** P = P(t, s). */
  class PressureContent : public GivenContent
  {
  public:
    PressureContent()
      : GivenContent("Pressure",
                     "0",
                     "[N/mm^2] The pressure above that outside: a formula of "
                     "the time t, the number s of the segment (from 1 at the "
                     "head) and the number n of segments.")
    {}

    CavityEquation
    equation(const CavityPoint &point) const override
    {
      return {point.pressure - given.value(point.segment, point.t),
              0.,
              1.,
              0.,
              point.stiffness};
    }

    std::optional<double>
    given_pressure(const unsigned int segment, const LoadTime &t) const override
    {
      return given.value(segment, t);
    }
  };

  static const Register<CavityContent, PressureContent>
    pressure_content("pressure",
                     "whatever has the pressure that is given, as behind a "
                     "valve.");
} // namespace lumbricus
