// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/cavities/cavity_content.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/patterns.h>

namespace lumbricus
{
  /** V = M (1 - P/kappa). */
  class LiquidContent : public CavityContent
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("Compressibility",
                        compressibility,
                        "[mm^2/N] 1/kappa: by which part of its volume the "
                        "liquid shrinks under a unit of pressure; 0 for an "
                        "incompressible one. Water has 4.5e-4.",
                        dealii::Patterns::Double(0.));
      prm.add_parameter("Density",
                        mass_density,
                        "[t/mm^3] Mass per volume at rest, for a body force "
                        "that is a weight; water has 1e-9.",
                        dealii::Patterns::Double(0.));
    }

    CavityEquation
    equation(const CavityPoint &point) const override
    {
      const double part = 1. - compressibility * point.pressure;
      return {point.amount * part - point.volume,
              -1.,
              -point.amount * compressibility,
              part,
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
      return true;
    }

  private:
    double compressibility = 0.;
    double mass_density    = 1.05e-9;
  };

  static const Register<CavityContent, LiquidContent>
    liquid_content("liquid", "a liquid that keeps its volume, or nearly so.");
} // namespace lumbricus
