// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/materials/isochoric_law.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/registry.h>

namespace lumbricus
{
  using dealii::SymmetricTensor;

  /**
   * The Neo-Hookean law (paper, equation 9 with b = 0):
   *
   *   W = a/2 (tr bbar - 3),   taubar = a bbar,   cbar = 0,   mu = a.
   */
  class NeoHooke : public IsochoricLaw
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("a",
                        a,
                        "[N/mm^2] Material constant, the shear modulus.",
                        PositiveNumber());
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
      return 0.5 * a * (trace(bbar) - 3.);
    }

    SymmetricTensor<2, dim>
    stress(const SymmetricTensor<2, dim> &bbar) const override
    {
      return a * bbar;
    }

    SymmetricTensor<4, dim>
    tangent(const SymmetricTensor<2, dim> & /*bbar*/) const override
    {
      return {};
    }

  private:
    double a = 0.23;
  };

  static const Register<MaterialLaw, NeoHooke>
    neo_hooke("Neo-Hooke",
              "W = a/2 (I1 - 3), for rubber, tissue and the rubber fluid.");
} // namespace lumbricus
