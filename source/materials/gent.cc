// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/materials/locking_law.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/registry.h>

#include <cmath>

#include "first_invariant_law.h"

namespace lumbricus
{
  /**
   * Gent's law (Rubber Chem. Technol. 69, 59, 1996), of chains that are
   * straight at x = I1 - 3 = J_m:
   *
   *   W = -mu J_m/2 ln(1 - x/J_m).
   *
   * From x = 0.99 J_m on, it is the parabola that goes on from there with the
   * same value, slope and curvature, so that trials of Newton's method that go
   * too far have a stress.
   */
  class Gent : public FirstInvariantLaw, public LockingLaw
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("mu",
                        mu,
                        "[N/mm^2] Shear modulus at rest.",
                        PositiveNumber());
      prm.add_parameter("J_m",
                        J_m,
                        "[-] The I1 - 3 that nothing can stretch it to. "
                        "Beyond 0.99 of it the law goes on as a parabola.",
                        PositiveNumber());
      IsochoricLaw::declare_parameters(prm);
    }

    void
    scale_stiffness(const double factor) override
    {
      mu *= factor;
    }

    // (I1 - 3)/J_m.
    double
    locking(const dealii::Tensor<2, dim> &F,
            const ReferencePoint         &reference) const override
    {
      const double F_e = (F * reference.G_inverse).norm();
      return (std::pow(determinant(F), -2. / dim) * F_e * F_e - 3.) / J_m;
    }

  protected:
    Derivatives
    derivatives(const double x) const override
    {
      const double end = 0.99 * J_m;
      if (x <= end)
        return exact(x);
      const Derivatives at = exact(end);
      const double      d  = x - end;
      return {at.energy + d * (at.first + 0.5 * d * at.second),
              at.first + d * at.second,
              at.second};
    }

  private:
    Derivatives
    exact(const double x) const
    {
      const double left = 1. - x / J_m;
      return {-0.5 * mu * J_m * std::log1p(-x / J_m),
              0.5 * mu / left,
              0.5 * mu / (J_m * left * left)};
    }

    double mu  = 0.23;
    double J_m = 50.;
  };

  static const Register<MaterialLaw, Gent>
    gent("Gent",
         "W = -mu J_m/2 ln(1 - (I1 - 3)/J_m), for rubber that locks.");
} // namespace lumbricus
