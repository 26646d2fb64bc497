// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/materials/isochoric_law.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/registry.h>

#include <cmath>

namespace
{
  using dealii::SymmetricTensor;
  using lumbricus::dim;

  /**
   * A tissue that stiffens when it is stretched (Demiray 1972, Journal of
   * Biomechanics 5, 309):
   *
   *   W = a/(2 b) (exp(b (tr bbar - 3)) - 1),
   *   taubar = a e bbar,   cbar = 2 a b e bbar x bbar,   e = exp(b (tr bbar -
   * 3)),
   *
   * with the shear modulus a at rest.
   */
  class Exponential : public lumbricus::IsochoricLaw
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("a",
                        a,
                        "[N/mm^2] Shear modulus at rest.",
                        lumbricus::PositiveNumber());
      prm.add_parameter("b",
                        b,
                        "[-] How fast it stiffens.",
                        lumbricus::PositiveNumber());
      IsochoricLaw::declare_parameters(prm);
    }

    double
    shear_modulus() const override
    {
      return a;
    }

    void
    scale_stiffness(const double factor) override
    {
      a *= factor;
    }

  protected:
    double
    isochoric_energy(const SymmetricTensor<2, dim> &bbar) const override
    {
      return 0.5 * a / b * std::expm1(b * (trace(bbar) - 3.));
    }

    SymmetricTensor<2, dim>
    stress(const SymmetricTensor<2, dim> &bbar) const override
    {
      return a * std::exp(b * (trace(bbar) - 3.)) * bbar;
    }

    SymmetricTensor<4, dim>
    tangent(const SymmetricTensor<2, dim> &bbar) const override
    {
      return 2. * a * b * std::exp(b * (trace(bbar) - 3.)) *
             outer_product(bbar, bbar);
    }

  private:
    double a = 0.1;
    double b = 1.;
  };

  // This is all it takes: parameter files can choose it now.
  const lumbricus::Register<lumbricus::MaterialLaw, Exponential>
    exponential("exponential",
                "W = a/(2b) (exp(b (I1 - 3)) - 1), for tissue that stiffens.");
} // namespace
