// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/registry.h>

#include <cmath>

#include "first_invariant_law.h"

namespace lumbricus
{
  /**
   * Demiray's law (J. Biomech. 5, 309, 1972), the ground of that of Holzapfel
   * and Ogden (Phil. Trans. R. Soc. A 367, 3445, 2009):
   *
   *   W = a/(2 b) (exp(b (I1 - 3)) - 1),   mu = a.
   */
  class Demiray : public FirstInvariantLaw
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("a",
                        a,
                        "[N/mm^2] Shear modulus at rest.",
                        PositiveNumber());
      prm.add_parameter("b",
                        b,
                        "[-] How fast it stiffens.",
                        PositiveNumber());
      IsochoricLaw::declare_parameters(prm);
    }

    void
    scale_stiffness(const double factor) override
    {
      a *= factor;
    }

  protected:
    Derivatives
    derivatives(const double x) const override
    {
      const double slope = 0.5 * a * std::exp(b * x);
      return {0.5 * a / b * std::expm1(b * x), slope, b * slope};
    }

  private:
    double a = 0.23;
    double b = 1.;
  };

  static const Register<MaterialLaw, Demiray>
    demiray("Demiray",
            "W = a/(2 b) (exp(b (I1 - 3)) - 1), for soft tissue and as the "
            "ground of fibres.");
} // namespace lumbricus
