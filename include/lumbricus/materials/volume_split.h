// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_materials_volume_split_h
#define lumbricus_materials_volume_split_h

#include <lumbricus/materials/material_law.h>

#include <deal.II/base/symmetric_tensor.h>

#include <vector>

namespace lumbricus
{
  /** What a law that splits off its volume change knows of the deformation. */
  struct IsochoricStrain
  {
    /** Fbar_e Fbar_e^T, with det bbar = 1. */
    dealii::SymmetricTensor<2, dim> bbar;
    /** Fbar_e f of the unit vector f along each family of fibres of the law in
     * the stress-free shape. */
    std::vector<dealii::Tensor<1, dim>> fibres;
  };



  /**
   * The mixed form of a hyperelastic law that splits off its volume change:
   *
   *   psi = J_v [ W(Fbar_e) + p (J/J_v - 1) - p^2 / (2 kappa) ],
   *   Fbar_e = J^(-1/3) F G^(-1),   kappa = 2 mu (1 + nu) / (3 (1 - 2 nu)),
   *
   * with nu = 0.5 exact (1/kappa = 0). In terms of the Kirchhoff stress
   *
   *   tau = J_v dev(taubar) + p J I,   P = tau F^(-T).
   *
   * A law of this kind gives W and its first two derivatives, and knows
   * nothing of volume, pressure, muscles or resets. One without fibres is an
   * IsochoricLaw.
   */
  class VolumeSplit : public MaterialLaw
  {
  public:
    /** Declares nu. */
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    double
    energy(const dealii::Tensor<2, dim> &F,
           const double                  p,
           const ReferencePoint         &reference) const override;

    void
    evaluate(const dealii::Tensor<2, dim> &F,
             const double                  p,
             const ReferencePoint         &reference,
             const bool                    with_tangent,
             MaterialResponse             &response) const override;

    /** 1/kappa, zero for nu = 0.5 [mm^2/N]. */
    double
    compressibility() const;

  protected:
    /** W [N/mm^2]. */
    virtual double
    energy_at(const IsochoricStrain &strain) const = 0;

    /** taubar = 2 Fbar_e dW/dCbar Fbar_e^T, before its trace is taken off,
     * where Cbar = Fbar_e^T Fbar_e. */
    virtual dealii::SymmetricTensor<2, dim>
    stress_at(const IsochoricStrain &strain) const = 0;

    /** cbar, which is 4 d2W/(dCbar dCbar) with each index taken to the deformed
     * shape by Fbar_e. */
    virtual dealii::SymmetricTensor<4, dim>
    tangent_at(const IsochoricStrain &strain) const = 0;

  private:
    double nu = 0.5;
  };
} // namespace lumbricus

#endif
