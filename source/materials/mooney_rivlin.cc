// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/materials/isochoric_law.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/registry.h>

namespace lumbricus
{
  using dealii::SymmetricTensor;

  /**
   * The Mooney-Rivlin law (paper, equation 9):
   *
   *   W = a/2 (I1 - 3) + b/2 (I2 - 3),   mu = a + b,
   *   taubar = a bbar + b (I1 bbar - bbar bbar),
   *   cbar = 2 b (bbar x bbar - bbar (.) bbar),
   *   (B (.) B)_ijkl = (B_ik B_jl + B_il B_jk) / 2.
   */
  class MooneyRivlin : public IsochoricLaw
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("a",
                        a,
                        "[N/mm^2] Material constant of I1.",
                        PositiveNumber());
      prm.add_parameter("b",
                        b,
                        "[N/mm^2] Material constant of I2.",
                        dealii::Patterns::Double(0.));
      IsochoricLaw::declare_parameters(prm);
    }

    double
    shear_modulus() const override
    {
      return a + b;
    }

    void
    scale_stiffness(const double factor) override
    {
      a *= factor;
      b *= factor;
    }

  protected:
    double
    isochoric_energy(const SymmetricTensor<2, dim> &bbar) const override
    {
      return 0.5 * a * (first_invariant(bbar) - 3.) +
             0.5 * b * (second_invariant(bbar) - 3.);
    }

    SymmetricTensor<2, dim>
    stress(const SymmetricTensor<2, dim> &bbar) const override
    {
      return (a + b * trace(bbar)) * bbar -
             b * dealii::symmetrize(dealii::Tensor<2, dim>(bbar) *
                                    dealii::Tensor<2, dim>(bbar));
    }

    SymmetricTensor<4, dim>
    tangent(const SymmetricTensor<2, dim> &bbar) const override
    {
      SymmetricTensor<4, dim> c;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = i; j < dim; ++j)
          for (unsigned int k = 0; k < dim; ++k)
            for (unsigned int l = k; l < dim; ++l)
              c[i][j][k][l] =
                2. * b *
                (bbar[i][j] * bbar[k][l] -
                 0.5 * (bbar[i][k] * bbar[j][l] + bbar[i][l] * bbar[j][k]));
      return c;
    }

  private:
    double a = 0.2;
    double b = 0.03;
  };

  static const Register<MaterialLaw, MooneyRivlin>
    mooney_rivlin("Mooney-Rivlin",
                  "W = a/2 (I1 - 3) + b/2 (I2 - 3), with shear modulus a + b.");
} // namespace lumbricus
