// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/cavities/cavity_content.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /** V = V_0 v(t, s). */
  class VolumeContent : public CavityContent
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      part.declare_parameter(
        prm,
        "[-] The volume relative to that at rest: a formula of the time t, the "
        "number s of the segment (from 1 at the head) and the number n of "
        "segments; more than 0.");
      prm.add_parameter("Density",
                        mass_density,
                        "[t/mm^3] Mass per volume of what is inside, for a body "
                        "force that is a weight; next to 0 for a gas.",
                        dealii::Patterns::Double(0.));
    }

    void
    initialize(const std::string & /*section*/,
               const Geometry &geometry) override
    {
      part.initialize(geometry);
    }

    CavityEquation
    equation(const CavityPoint &point) const override
    {
      return {point.volume_at_rest * part.value(point.segment, point.t, 1.) -
                point.volume,
              -1.,
              0.,
              0.,
              point.volume_at_rest};
    }

    double
    density() const override
    {
      return mass_density;
    }

    bool
    keeps_amount() const override
    {
      return false;
    }

    std::vector<const SegmentExpression *>
    expressions() const override
    {
      return {&part};
    }

    void
    check_at(const unsigned int segment, const double t) const override
    {
      const double v = part.value(segment, t);
      AssertThrow(v > 0.,
                  ExcParameter(part.parameter(),
                               "is " + dealii::Utilities::to_string(v) +
                                 " for segment " + std::to_string(segment + 1) +
                                 " at time " + dealii::Utilities::to_string(t) +
                                 ", but a chamber has a volume of more than 0. "
                                 "At rest it is 1."));
    }

  private:
    double            mass_density = 0.;
    SegmentExpression part = {"Relative volume", "1"};
  };

  static const Register<CavityContent, VolumeContent>
    volume_content("volume",
                   "whatever makes its volume the one that is given, as a pump "
                   "does.");
} // namespace lumbricus
