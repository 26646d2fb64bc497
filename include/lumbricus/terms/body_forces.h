// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_terms_body_forces_h
#define lumbricus_terms_body_forces_h

#include <lumbricus/core/load_curve.h>
#include <lumbricus/geometry/geometry.h>
#include <lumbricus/parameters/named_sections.h>
#include <lumbricus/parameters/registry.h>
#include <lumbricus/terms/volume_term.h>

#include <deal.II/distributed/tria_base.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /** One section of Body forces: what acts in which tissues. */
  class NamedBodyForce : public ParameterOwner
  {
  public:
    /** What the section Body forces/@p name says. */
    explicit NamedBodyForce(const std::string &name);

    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    bool
    extend_parameters(dealii::ParameterHandler &prm,
                      const Extent              extent) override;

    void
    check_parameters() const override;

    /** The name of the section. */
    std::string name;
    /** The names of the tissues; none for all but liquids. */
    std::vector<std::string> tissues;
    /** What acts there. */
    Choice<VolumeTerm> type;
    /** Whether it acts in a tissue, by number: BodyForces::initialize(). */
    std::vector<bool> acts_in;
  };



  /** All body forces of a run. */
  class BodyForces : public ParameterOwner
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    bool
    extend_parameters(dealii::ParameterHandler &prm,
                      const Extent              extent) override;

    void
    check_parameters() const override;

    /**
     * Find the tissues and read the expressions. Throws ExcInput for a tissue
     * that does not exist, and for a liquid: the mesh inside it does not move
     * with its points, which a force would have to know.
     */
    void
    initialize(const Geometry &geometry);

    /**
     * Try all expressions in the middle of cells they are for, at @p times.
     * Throws ExcInput where a value is NaN or infinite. Collective.
     */
    void
    try_expressions(
      const dealii::parallel::TriangulationBase<dim> &triangulation,
      const std::vector<double>                      &times) const;

    /** All expressions over time; the same on all ranks. */
    std::vector<LoadCurve>
    load_curves(
      const dealii::parallel::TriangulationBase<dim> &triangulation) const;

    /** How many there are. */
    unsigned int
    n_forces() const;

    /** Number @p i of n_forces(), in the order of their names. */
    const NamedBodyForce &
    force(const unsigned int i) const;

    /** Whether the tangent matrix is symmetric. */
    bool
    symmetric() const;

  private:
    std::vector<std::string>      names;
    NamedSections<NamedBodyForce> forces;
  };
} // namespace lumbricus

#endif
