// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_anatomy_tissue_h
#define lumbricus_anatomy_tissue_h

#include <lumbricus/anatomy/fibre_coupling.h>
#include <lumbricus/anatomy/fibre_family.h>
#include <lumbricus/anatomy/material_point.h>
#include <lumbricus/anatomy/muscle.h>
#include <lumbricus/anatomy/viscous_branch.h>
#include <lumbricus/materials/material_law.h>
#include <lumbricus/parameters/named_list.h>
#include <lumbricus/parameters/registry.h>
#include <lumbricus/parameters/section.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /** A tissue of the body: its law, elastic fibres in it, viscous branches beside
   * it, and the muscles whose fibres run in it. What a point answers to its
   * deformation is the answer of all. */
  class Tissue : public PartOfBody
  {
  public:
    /** The tissue of the section Tissues/@p name. */
    explicit Tissue(const std::string &name);

    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    bool
    extend_parameters(dealii::ParameterHandler &prm,
                      const Extent              extent) override;

    void
    check_parameters() const override;

    /** Those of its law and of its elastic fibres. */
    void
    initialize(const std::string &section, const Geometry &geometry) override;

    /** Let its law be, by default, that of the liquid inside a wall. Only
     * before extend_parameters(). */
    void
    make_liquid();

    /** Give it the muscles of muscle_names(), in that order; they are kept by
     * reference. After the parameters are read, before evaluate(). */
    void
    set_muscles(const std::vector<const Muscle *> &muscles);

    /** The name of its section, see TissueName. */
    const std::string &
    name() const;

    /** Its constitutive law. */
    const MaterialLaw &
    law() const;

    /** The name of that law, as users choose it. */
    const std::string &
    law_name() const;

    /** The shear modulus of the law and of all viscous branches: that against a
     * quick motion at zero strain [N/mm^2]. */
    double
    shear_modulus() const;

    /** The path of the law's section, for messages. */
    std::string
    law_section() const;

    /** Mass per volume at rest [t/mm^3]. */
    double
    density() const
    {
      return mass_density;
    }

    /** Names of sections in Muscles. */
    const std::vector<std::string> &
    muscle_names() const;

    /** Its muscles. */
    const std::vector<const Muscle *> &
    muscles() const;

    /** Whether it has elastic fibres, of its law or beside it. */
    bool
    has_elastic_fibres() const;

    /** Its families of elastic fibres, without those of its law. */
    const NamedList<FibreFamily> &
    fibre_families() const;

    /** What holds two of these families at their angle. */
    const NamedList<FibreCoupling> &
    fibre_couplings() const;

    /** Its viscous branches. */
    const NamedList<ViscousBranch> &
    viscous_branches() const;

    /** The unit vectors at @p X along its elastic fibres: those of its law, then
     * its families. Throws ExcInput, naming the tissue. */
    std::vector<dealii::Tensor<1, dim>>
    elastic_fibres(const dealii::Point<dim> &X) const;

    /** The reference map that its muscles make, where their fibres are @p
     * fibres, one per muscle, and what it does to elastic fibres that have the
     * directions @p elastic at rest. */
    ReferencePoint
    reference_map(const std::vector<MuscleFibre>            &fibres,
                  const std::vector<dealii::Tensor<1, dim>> &elastic) const;

    /** psi of the law, of the elastic fibres and of their couplings [N/mm^2]. */
    double
    energy(const dealii::Tensor<2, dim> &F,
           const double                  p,
           const ReferencePoint         &reference) const;

    /** psi of the viscous branches at the end of a step that ends at @p F
     * [N/mm^2]. */
    double
    viscous_energy(const dealii::Tensor<2, dim> &F,
                   const MaterialPoint          &point) const;

    /** What they dissipate in the step from @p F_n to @p F [N/mm^2]. */
    double
    dissipated(const dealii::Tensor<2, dim> &F_n,
               const dealii::Tensor<2, dim> &F,
               const MaterialPoint          &point) const;

    /**
     * The response of law, fibres, branches and muscles at @p point: P, Q, c and dc_dp, and A where @p with_tangent, at the deformation gradient @p F with
     * det F > 0 and the pressure variable @p p (positive in tension).
     */
    void
    evaluate(const dealii::Tensor<2, dim> &F,
             const double                  p,
             const MaterialPoint          &point,
             const bool                    with_tangent,
             MaterialResponse             &response) const;

  private:
    const std::string        tissue_name;
    Choice<MaterialLaw>      law_choice;
    double                   mass_density = 1.05e-9;
    std::vector<std::string> names_of_muscles;
    Section<NamedList<FibreFamily>>   families;
    Section<NamedList<FibreCoupling>> couplings;
    Section<NamedList<ViscousBranch>> branches;

    // What was chosen, found once: evaluate() is called at every point.
    const MaterialLaw                *chosen_law = nullptr;
    std::vector<const Muscle *>       its_muscles;
    std::vector<const MuscleAction *> actions;
  };
} // namespace lumbricus

#endif
