// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_anatomy_viscous_branch_h
#define lumbricus_anatomy_viscous_branch_h

#include <lumbricus/anatomy/viscous_point.h>
#include <lumbricus/geometry/part_of_body.h>
#include <lumbricus/materials/material_law.h>

#include <string>

namespace lumbricus
{
  /**
   * A Maxwell element beside the law of a tissue, a spring and a dashpot one after
   * the other, of the shear modulus mu and the relaxation time tau (Lubliner, Mech.
   * Res. Commun. 12, 93, 1985). The spring is Neo-Hookean, the dashpot has an own
   * reference map G_v, and with b = (G_v^T G_v)^(-1), which is I at rest,
   *
   *   psi = mu/2 (tr(Cbar b) - 3 - ln det b),   Cbar = J^(-2/3) F^T F,
   *   db/dt = (Cbar^(-1) - b) / tau,
   *
   * so that a held shape relaxes by exp(-t/tau), and mu/(2 tau) (tr(Cbar b) +
   * tr((Cbar b)^(-1)) - 6) >= 0 is dissipated. F is that of the displacements: what
   * muscles do to the stress-free shape and growth do not strain it, only motion
   * does.
   *
   * Over a load step of the length dt, with Cbar^(-1) linear in time, exactly
   *
   *   b_(n+1) = h + (1 - m) Cbar_(n+1)^(-1),   h = e b_n + (m - e) Cbar_n^(-1),
   *   e = exp(-x),   m = (1 - e)/x,   x = dt/tau.
   *
   * The stress is that of psi at b_(n+1) held fast. What is there of Cbar_(n+1)^(-1)
   * makes a pressure only, and that of psi is without one:
   *
   *   P = mu J^(-2/3) (F h - tr(C h)/3 F^(-T)),
   *
   * of which A is the derivative, with h fixed.
   */
  class ViscousBranch : public PartOfBody
  {
  public:
    /** The branch of the section @p name. */
    explicit ViscousBranch(const std::string &name);

    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    /** mu [N/mm^2]. */
    double
    shear_modulus() const
    {
      return mu;
    }

    /** What there is at a point in a load step that began @p since ago, >= 0, with
     * @p b and with @p inverse = inverse_shape(F_n). */
    ViscousPoint
    in_step(const dealii::SymmetricTensor<2, dim> &b,
            const dealii::SymmetricTensor<2, dim> &inverse,
            const double                           since) const;

    /** psi at @p F and @p b [N/mm^2]. */
    double
    energy(const dealii::Tensor<2, dim>          &F,
           const dealii::SymmetricTensor<2, dim> &b) const;

    /**
     * What is dissipated in the step from @p F_n to @p F, at least 0 [N/mm^2]. With
     * s = Cbar^(-1) - b
     *
     *   mu/(2 tau) int tr(b^(-1) s Cbar s) dt,
     *
     * where s changes in time as above, exactly, so that steps may be much longer
     * than tau, and of b^(-1) and Cbar the mean of both ends is taken.
     */
    double
    dissipated(const dealii::Tensor<2, dim> &F_n,
               const dealii::Tensor<2, dim> &F,
               const ViscousPoint           &point) const;

    /** Add P at the end of a step to that of @p response and, where @p
     * with_tangent, its derivative to A. */
    void
    add_stress(const dealii::Tensor<2, dim> &F,
               const ViscousPoint           &point,
               const bool                    with_tangent,
               MaterialResponse             &response) const;

  private:
    double mu  = 0.1;
    double tau = 1.;
  };
} // namespace lumbricus

#endif
