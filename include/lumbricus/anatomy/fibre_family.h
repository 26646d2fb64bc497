// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_anatomy_fibre_family_h
#define lumbricus_anatomy_fibre_family_h

#include <lumbricus/anatomy/exponential_energy.h>
#include <lumbricus/fibres/fibre_field.h>
#include <lumbricus/geometry/part_of_body.h>
#include <lumbricus/materials/material_law.h>
#include <lumbricus/parameters/registry.h>

#include <string>

namespace lumbricus
{
  /**
   * Elastic fibres that strengthen the ground of a tissue, whatever its law is:
   * those of Gasser, Ogden and Holzapfel (J. R. Soc. Interface 3, 15, 2006), in
   * tension only,
   *
   *   psi = J_v k1/(2 k2) (exp(k2 E^2) - 1) for E > 0, else 0,
   *   E = kappa (I1 - 3) + (1 - 3 kappa) (I4 - 1),
   *   I1 = tr(F_e^T F_e) J_v^(-2/3),   I4 = (|F f|/|G f|)^2 J_v^(-2/3).
   *
   * I1 and I4 are those of F and not of its isochoric part, so that no fibre is
   * shortened by a change of volume that is not there. Order: G changes the
   * stress-free shape with the fibres in it, and then F_e strains both; so fibres
   * are as free of stress where F = G as the ground is.
   */
  class FibreFamily : public PartOfBody
  {
  public:
    /** The family of the section @p name. */
    explicit FibreFamily(const std::string &name);

    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    bool
    extend_parameters(dealii::ParameterHandler &prm,
                      const Extent              extent) override;

    void
    check_parameters() const override;

    /** That of the direction. */
    void
    initialize(const std::string &section, const Geometry &geometry) override;

    /** The direction of the fibres. */
    const FibreField &
    fibres() const
    {
      return *fibre_choice;
    }

    /** Whether those of @p other are as stiff, in whatever direction. */
    bool
    is_as_stiff_as(const FibreFamily &other) const;

    /** psi at F, where @p fibre is its vector of ReferencePoint::fibres
     * [N/mm^2]. */
    double
    energy(const dealii::Tensor<2, dim> &F,
           const ReferencePoint         &reference,
           const dealii::Tensor<1, dim> &fibre) const;

    /** Add d psi/dF to P and, where @p with_tangent, its derivative to A. */
    void
    add_stress(const dealii::Tensor<2, dim> &F,
               const ReferencePoint         &reference,
               const dealii::Tensor<1, dim> &fibre,
               const bool                    with_tangent,
               MaterialResponse             &response) const;

  private:
    /** M of E = F^T F : M - 1. */
    dealii::SymmetricTensor<2, dim>
    structure(const ReferencePoint         &reference,
              const dealii::Tensor<1, dim> &fibre) const;

    /** Its energy at a strain > 0. */
    ExponentialEnergy
    stiffening(const ReferencePoint &reference) const;

    double             k1    = 0.1;
    double             k2    = 1.;
    double             kappa = 0.;
    Choice<FibreField> fibre_choice;
  };
} // namespace lumbricus

#endif
