// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_materials_first_invariant_law_h
#define lumbricus_materials_first_invariant_law_h

#include <lumbricus/materials/isochoric_law.h>

namespace lumbricus
{
  /**
   * A law whose energy is a function of x = tr bbar - 3 alone,
   *
   *   taubar = 2 W' bbar,   cbar = 4 W'' bbar x bbar,   mu = 2 W'(0).
   */
  class FirstInvariantLaw : public IsochoricLaw
  {
  public:
    double
    shear_modulus() const override
    {
      return 2. * derivatives(0.).first;
    }

  protected:
    /** W and its derivatives by x = I1 - 3. */
    struct Derivatives
    {
      double energy; ///< W [N/mm^2]
      double first;  ///< W' [N/mm^2]
      double second; ///< W'' [N/mm^2]
    };

    /** Those at @p x >= 0. */
    virtual Derivatives
    derivatives(const double x) const = 0;

    double
    isochoric_energy(
      const dealii::SymmetricTensor<2, dim> &bbar) const override
    {
      return derivatives(trace(bbar) - 3.).energy;
    }

    dealii::SymmetricTensor<2, dim>
    stress(const dealii::SymmetricTensor<2, dim> &bbar) const override
    {
      return 2. * derivatives(trace(bbar) - 3.).first * bbar;
    }

    dealii::SymmetricTensor<4, dim>
    tangent(const dealii::SymmetricTensor<2, dim> &bbar) const override
    {
      return 4. * derivatives(trace(bbar) - 3.).second *
             dealii::outer_product(bbar, bbar);
    }
  };
} // namespace lumbricus

#endif
