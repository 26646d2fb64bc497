// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/cavities/cavity_content.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/patterns.h>

#include <optional>
#include <string>
#include <vector>

namespace lumbricus
{
  /** P = P(t, s). */
  class PressureContent : public CavityContent
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      given.declare_parameter(
        prm,
        "[N/mm^2] The pressure above that outside: a formula of the time t, "
        "the number s of the segment (from 1 at the head) and the number n of "
        "segments.");
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
      given.initialize(geometry);
    }

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
      return {&given};
    }

  private:
    double            mass_density = 0.;
    SegmentExpression given = {"Pressure", "0"};
  };

  static const Register<CavityContent, PressureContent>
    pressure_content("pressure",
                     "whatever has the pressure that is given, as behind a "
                     "valve.");
} // namespace lumbricus
