// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_materials_material_law_h
#define lumbricus_materials_material_law_h

#include <lumbricus/core/dimension.h>
#include <lumbricus/fibres/fibre_field.h>
#include <lumbricus/geometry/part_of_body.h>
#include <lumbricus/reference_map/reference_point.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace lumbricus
{
  /**
   * The response of a material at a point, derived from an energy
   * psi(F, p) per volume of the mesh's configuration that is stationary in p:
   *
   *   P = d psi / dF,         the first Piola-Kirchhoff stress P_iJ,
   *
   *   c = d psi / dp,         zero in equilibrium,
   *
   *   A = d2 psi / dF dF,     A[3 i + J][3 k + L], symmetric,
   *
   *   Q = d2 psi / dF dp,     which is dP/dp = dc/dF,
   *
   *   dc_dp = d2 psi / dp2.
   *
   * A liquid that flows has no shear stress (flowing_response()). Its A has a
   * small shear stiffness nevertheless, and a preconditioner more of it.
   */
  struct MaterialResponse
  {
    dealii::Tensor<2, dim> P;     ///< [N/mm^2], [i][J]
    dealii::Tensor<2, dim> Q;     ///< [i][J]
    double                 c;     ///< violated volume constraint
    double                 dc_dp; ///< [mm^2/N]
    double                 A[dim * dim][dim * dim]; ///< [N/mm^2]
    /** The shear modulus that A lacks for a preconditioner [N/mm^2]. */
    double mu_missing = 0.;
  };



  /** A constitutive law of the displacement-pressure form. Tensors only. */
  class MaterialLaw : public PartOfBody
  {
  public:
    /** The fibres that make it anisotropic, those of ReferencePoint::fibres, in
     * their order. After initialize(). */
    virtual std::vector<const FibreField *>
    fibre_fields() const
    {
      return {};
    }

    /** psi(F, p), for tests and energy balances [N/mm^2]. */
    virtual double
    energy(const dealii::Tensor<2, dim> &F,
           const double                  p,
           const ReferencePoint         &reference) const = 0;

    /**
     * P, Q, c and dc_dp, and A where @p with_tangent, at the deformation
     * gradient @p F with det F > 0 and the pressure variable @p p (positive
     * in tension).
     */
    virtual void
    evaluate(const dealii::Tensor<2, dim> &F,
             const double                  p,
             const ReferencePoint         &reference,
             const bool                    with_tangent,
             MaterialResponse             &response) const = 0;

    /** The shear modulus mu at zero strain [N/mm^2]. */
    virtual double
    shear_modulus() const = 0;

    /** Whether P is p J F^(-T) in a shape that is free of shear, so that a liquid
     * of this law may flow (flowing_response()). */
    virtual bool
    may_flow() const
    {
      return false;
    }

    /**
     * Multiply the stiffness by @p factor. Before the parameters are declared
     * this changes their defaults: a liquid's are those of a very soft rubber.
     * Where a law does not do it, a liquid of it has to be given its stiffness.
     */
    virtual void
    scale_stiffness(const double /*factor*/)
    {}
  };
} // namespace lumbricus

#endif
