// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/cavities/cavity_content.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/patterns.h>

#include <cmath>
#include <string>
#include <vector>

namespace lumbricus
{
  /** V = M (P_rest / (P + P_outside))^(1/gamma), absolute pressures. */
  class GasContent : public CavityContent
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("Absolute pressure at rest",
                        at_rest,
                        "[N/mm^2] That of the gas while the body is at rest. "
                        "The atmosphere has 0.101325.",
                        PositiveNumber());
      outside.declare_parameter(
        prm,
        "[N/mm^2] That around the body, above which the pressure of the cavity "
        "is counted: a formula of the time t, the number s of the segment and "
        "the number n of segments; at least 0, which is vacuum.");
      prm.add_parameter("Exponent",
                        gamma,
                        "[-] 1 for a gas that keeps its temperature, 1.4 for "
                        "air that keeps its heat.",
                        dealii::Patterns::Double(1.));
    }

    void
    initialize(const std::string & /*section*/,
               const Geometry &geometry) override
    {
      outside.initialize(geometry);
    }

    CavityEquation
    equation(const CavityPoint &point) const override
    {
      // p V^gamma = p_0 M^gamma in the form that has a solution for every
      // iterate of Newton's method: for P, which may be anything on the way.
      const double gas =
        at_rest * std::pow(point.amount / point.volume, gamma);
      return {point.pressure -
                (gas - outside.value(point.segment, point.t, at_rest)),
              gamma * gas / point.volume,
              1.,
              -gamma * gas / point.amount,
              at_rest};
    }

    double
    density() const override
    {
      return 0.;
    }

    bool
    keeps_amount() const override
    {
      return true;
    }

    std::string
    cannot_flow() const override
    {
      return gamma == 1. ?
               "" :
               "keeps its heat, and what flows would carry heat away. Set its "
               "'Exponent' to 1";
    }

    std::vector<const SegmentExpression *>
    expressions() const override
    {
      return {&outside};
    }

    void
    check_at(const unsigned int segment, const double t) const override
    {
      AssertThrow(outside.value(segment, t) >= 0.,
                  ExcParameter(outside.parameter(),
                               outside.value_text(segment, t, "N/mm^2") +
                                 ", but no absolute pressure is below that of "
                                 "vacuum, 0. The atmosphere has 0.101325."));
    }

  private:
    double            at_rest = 0.101325;
    SegmentExpression outside = {"Absolute pressure outside", "0.101325"};
    double            gamma   = 1.;
  };

  static const Register<CavityContent, GasContent>
    gas_content("gas", "a gas, of a constant temperature or not.");
} // namespace lumbricus
