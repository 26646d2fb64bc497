// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/cavities/cavity_content.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/patterns.h>

#include <cmath>
#include <string>

namespace lumbricus
{
  /** Vhat = V_0 (P_rest / (P + P_outside))^(1/gamma), absolute pressures. */
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
      prm.add_parameter("Absolute pressure outside",
                        outside,
                        "[N/mm^2] That around the body, above which the "
                        "pressure of the cavity is counted.",
                        dealii::Patterns::Double(0.));
      prm.add_parameter("Exponent",
                        gamma,
                        "[-] 1 for a gas that keeps its temperature, 1.4 for "
                        "air that keeps its heat.",
                        dealii::Patterns::Double(1.));
    }

    CavityEquation
    equation(const CavityPoint &point) const override
    {
      // p V^gamma = p_0 V_0^gamma in the form that has a solution for every
      // iterate of Newton's method: for P, which may be anything on the way.
      const double V_0 = point.volume_at_rest;
      const double gas = at_rest * std::pow(V_0 / point.volume, gamma);
      return {point.pressure - (gas - outside),
              gamma * gas / point.volume,
              1.,
              at_rest};
    }

  private:
    double at_rest = 0.101325;
    double outside = 0.101325;
    double gamma   = 1.;
  };

  static const Register<CavityContent, GasContent>
    gas_content("gas", "a gas, of a constant temperature or not.");
} // namespace lumbricus
