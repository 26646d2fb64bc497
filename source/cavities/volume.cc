// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/parameters/registry.h>

#include "given_content.h"

namespace lumbricus
{
  /** V = V_0 v(t, s). */
  class VolumeContent : public GivenContent
  {
  public:
    VolumeContent()
      : GivenContent("Relative volume",
                     "1",
                     "[-] The volume relative to that at rest: a formula of the "
                     "time t, the number s of the segment (from 1 at the head) "
                     "and the number n of segments; more than 0.")
    {}

    CavityEquation
    equation(const CavityPoint &point) const override
    {
      return {point.volume_at_rest * given.value(point.segment, point.t, 1.) -
                point.volume,
              -1.,
              0.,
              0.,
              point.volume_at_rest};
    }

    void
    check_at(const unsigned int segment, const double t) const override
    {
      AssertThrow(given.value(segment, t) > 0.,
                  ExcParameter(given.parameter(),
                               given.value_text(segment, t) +
                                 ", but a chamber has a volume of more than 0. "
                                 "At rest it is 1."));
    }
  };

  static const Register<CavityContent, VolumeContent>
    volume_content("volume",
                   "whatever makes its volume the one that is given, as a pump "
                   "does.");
} // namespace lumbricus
