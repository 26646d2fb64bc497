// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_anatomy_fibre_coupling_h
#define lumbricus_anatomy_fibre_coupling_h

#include <lumbricus/geometry/part_of_body.h>
#include <lumbricus/materials/material_law.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * What holds two families of elastic fibres, f and s, at their angle: the coupling
   * of Holzapfel and Ogden (Phil. Trans. R. Soc. A 367, 3445, 2009), as of the fibres
   * and the sheets of the heart,
   *
   *   psi = J_v a/(2 b) (exp(b E^2) - 1),   E = I8 - I8_0,
   *   I8 = (F f) . (F s)/(|G f| |G s|) J_v^(-2/3),
   *   I8_0 = (G f) . (G s)/(|G f| |G s|),
   *
   * I8 of F and not of its isochoric part, as FibreFamily has it. I8_0, which is what
   * I8 is at F = J_v^(1/3) G, is zero where families are at right angles, as theirs
   * are; so fibres at any angle are free of stress there. A sign of f or s makes no
   * difference. Unlike the families it resists both a smaller and a larger angle.
   */
  class FibreCoupling : public PartOfBody
  {
  public:
    /** Of the section @p name. */
    explicit FibreCoupling(const std::string &name);

    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    /** Find its two families among @p families, the names of those of the tissue.
     * Throws ExcInput naming the parameter, in the section @p section, where they
     * are not two of them. */
    void
    find_families(const std::string              &section,
                  const std::vector<std::string> &families);

    /** Where its first (0) or second family is in the list of the tissue's. */
    unsigned int
    family(const unsigned int i) const
    {
      return places[i];
    }

    /** Whether @p other is as stiff, between whatever families. */
    bool
    is_as_stiff_as(const FibreCoupling &other) const;

    /** psi at F, where @p f and @p s are the vectors of ReferencePoint::fibres of
     * its families [N/mm^2]. */
    double
    energy(const dealii::Tensor<2, dim> &F,
           const ReferencePoint         &reference,
           const dealii::Tensor<1, dim> &f,
           const dealii::Tensor<1, dim> &s) const;

    /** Add d psi/dF to P and, where @p with_tangent, its derivative to A. */
    void
    add_stress(const dealii::Tensor<2, dim> &F,
               const ReferencePoint         &reference,
               const dealii::Tensor<1, dim> &f,
               const dealii::Tensor<1, dim> &s,
               const bool                    with_tangent,
               MaterialResponse             &response) const;

  private:
    const std::string        coupling_name;
    std::vector<std::string> between;
    double                   a = 0.1;
    double                   b = 1.;
    unsigned int             places[2] = {0, 0};
  };
} // namespace lumbricus

#endif
