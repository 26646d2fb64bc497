// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/registry.h>

#include "first_invariant_law.h"

namespace lumbricus
{
  /**
   * Yeoh's law (Rubber Chem. Technol. 66, 754, 1993):
   *
   *   W = C1 x + C2 x^2 + C3 x^3,   x = I1 - 3,   mu = 2 C1.
   */
  class Yeoh : public FirstInvariantLaw
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("C1",
                        C1,
                        "[N/mm^2] Material constant of I1 - 3, half of the "
                        "shear modulus.",
                        PositiveNumber());
      prm.add_parameter("C2",
                        C2,
                        "[N/mm^2] Material constant of (I1 - 3)^2; it may be "
                        "negative.",
                        dealii::Patterns::Double(-1e100, 1e100));
      prm.add_parameter("C3",
                        C3,
                        "[N/mm^2] Material constant of (I1 - 3)^3.",
                        dealii::Patterns::Double(0., 1e100));
      IsochoricLaw::declare_parameters(prm);
    }

    void
    check_parameters() const override
    {
      AssertThrow(C2 >= 0. || C2 * C2 < 3. * C1 * C3,
                  ExcParameter("C2",
                               "is so negative that the rubber has no "
                               "stiffness left from some stretch on: "
                               "C1 + 2 C2 x + 3 C3 x^2 has to be positive "
                               "for all x = I1 - 3. Raise 'C2' or 'C3'."));
    }

    void
    scale_stiffness(const double factor) override
    {
      C1 *= factor;
      C2 *= factor;
      C3 *= factor;
    }

  protected:
    Derivatives
    derivatives(const double x) const override
    {
      return {x * (C1 + x * (C2 + x * C3)),
              C1 + x * (2. * C2 + x * 3. * C3),
              2. * C2 + 6. * C3 * x};
    }

  private:
    double C1 = 0.115;
    double C2 = 0.;
    double C3 = 0.;
  };

  static const Register<MaterialLaw, Yeoh>
    yeoh("Yeoh",
         "W = C1 (I1 - 3) + C2 (I1 - 3)^2 + C3 (I1 - 3)^3, for silicone.");
} // namespace lumbricus
