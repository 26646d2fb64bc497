// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_anatomy_anatomy_h
#define lumbricus_anatomy_anatomy_h

#include <lumbricus/anatomy/muscle.h>
#include <lumbricus/anatomy/tissue.h>
#include <lumbricus/geometry/geometry.h>
#include <lumbricus/parameters/named_sections.h>
#include <lumbricus/parameters/registry.h>
#include <lumbricus/parameters/section.h>

#include <deal.II/distributed/tria_base.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * What the body is made of: a geometry, a tissue for every name the
   * geometry has, and the muscles the tissues name.
   */
  class Anatomy : public ParameterOwner
  {
  public:
    /** A segment chain, until parameters say otherwise. */
    Anatomy();

    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    bool
    extend_parameters(dealii::ParameterHandler &prm,
                      const Extent              extent) override;

    void
    check_parameters() const override;

    /** Give the tissues their muscles, and initialize these. Throws
     * ExcInput. */
    void
    initialize();

    /**
     * Try the activation of every muscle in the middle of a cell of every
     * segment it is in, at @p times. Throws ExcInput where the muscle's action
     * cannot take it. Collective.
     */
    void
    try_activations(
      const dealii::parallel::TriangulationBase<dim> &triangulation,
      const std::vector<double>                      &times) const;

    /** The activation of every muscle without HeldValues in every segment it is
     * in, over time; the same on all ranks. */
    std::vector<LoadCurve>
    load_curves(
      const dealii::parallel::TriangulationBase<dim> &triangulation) const;

    /** The shape of the body. */
    const Geometry &
    geometry() const;

    /** Tissue number @p i, as in Region::tissue. */
    const Tissue &
    tissue(const unsigned int i) const;

    /** Whether tissue number @p tissue is a liquid, which is reset. */
    bool
    is_liquid(const unsigned int tissue) const;

    /** Whether any tissue is liquid. */
    bool
    has_liquid() const;

    /** Whether the laws of all liquids are such that they may flow. */
    bool
    liquids_may_flow() const;

    /** The muscles of tissue number @p tissue. */
    const std::vector<const Muscle *> &
    muscles_of(const unsigned int tissue) const;

    /** How many viscous branches the tissue has that has most of them. */
    unsigned int
    n_viscous_branches() const;

    /** How many muscles the tissues name. */
    unsigned int
    n_muscles() const;

    /** Muscle number @p i of n_muscles(), in the order in which tissues name
     * them first. */
    const Muscle &
    muscle(const unsigned int i) const;

    /** The tissue of the section Tissues/@p name, one of the geometry's. */
    const Tissue &
    tissue(const std::string &name) const;

    /** The largest shear modulus of all tissues that are not liquid, or of
     * all where there are no others. */
    double
    wall_stiffness() const;

  private:
    std::vector<std::string>
    all_muscle_names() const;

    /** No two muscles whose fields are called the same. */
    void
    check_field_names() const;

    void
    check_liquids() const;

    Section<Choice<Geometry>> geometry_choice;
    NamedSections<Tissue>     tissues;
    NamedSections<Muscle>     muscles;
    std::vector<TissueName>   tissue_names;
  };
} // namespace lumbricus

#endif
