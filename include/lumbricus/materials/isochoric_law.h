// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_materials_isochoric_law_h
#define lumbricus_materials_isochoric_law_h

#include <lumbricus/materials/material_law.h>

#include <deal.II/base/symmetric_tensor.h>

namespace lumbricus
{
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
   * nothing of volume, pressure, muscles or resets.
   */
  class IsochoricLaw : public MaterialLaw
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

    bool
    may_flow() const override
    {
      return true;
    }

    /** 1/kappa, zero for nu = 0.5 [mm^2/N]. */
    double
    compressibility() const;

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
    double nu = 0.5;
  };
} // namespace lumbricus

#endif
