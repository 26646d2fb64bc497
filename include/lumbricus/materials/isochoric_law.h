// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_materials_isochoric_law_h
#define lumbricus_materials_isochoric_law_h

#include <lumbricus/materials/volume_split.h>

#include <deal.II/base/symmetric_tensor.h>

namespace lumbricus
{
  /** A VolumeSplit without fibres: W is a function of bbar alone. */
  class IsochoricLaw : public VolumeSplit
  {
  public:
    bool
    may_flow() const override
    {
      return true;
    }

  protected:
    /** W as a function of bbar = Fbar_e Fbar_e^T, with det bbar = 1. */
    virtual double
    isochoric_energy(const dealii::SymmetricTensor<2, dim> &bbar) const = 0;

    /** taubar = 2 bbar dW/dbbar, before its trace is taken off. */
    virtual dealii::SymmetricTensor<2, dim>
    stress(const dealii::SymmetricTensor<2, dim> &bbar) const = 0;

    /** cbar = 4 bbar d2W/(dbbar dbbar) bbar; zero for a Neo-Hookean law. */
    virtual dealii::SymmetricTensor<4, dim>
    tangent(const dealii::SymmetricTensor<2, dim> &bbar) const = 0;

  private:
    double
    energy_at(const IsochoricStrain &strain) const final
    {
      return isochoric_energy(strain.bbar);
    }

    dealii::SymmetricTensor<2, dim>
    stress_at(const IsochoricStrain &strain) const final
    {
      return stress(strain.bbar);
    }

    dealii::SymmetricTensor<4, dim>
    tangent_at(const IsochoricStrain &strain) const final
    {
      return tangent(strain.bbar);
    }
  };
} // namespace lumbricus

#endif
