// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_terms_boundary_conditions_h
#define lumbricus_terms_boundary_conditions_h

#include <lumbricus/core/load_curve.h>
#include <lumbricus/geometry/geometry.h>
#include <lumbricus/parameters/named_sections.h>
#include <lumbricus/parameters/registry.h>
#include <lumbricus/terms/prescribed_displacement.h>
#include <lumbricus/terms/surface_term.h>

#include <deal.II/distributed/tria_base.h>

#include <map>
#include <string>
#include <vector>

namespace lumbricus
{
  /** One section of Boundary conditions: what acts where. */
  class NamedCondition : public ParameterOwner
  {
  public:
    /** What the section Boundary conditions/@p name says. */
    explicit NamedCondition(const std::string &name);

    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    bool
    extend_parameters(dealii::ParameterHandler &prm,
                      const Extent              extent) override;

    void
    check_parameters() const override;

    /** What acts there as a traction, or nullptr. */
    const SurfaceTerm *
    surface_term() const;

    /** What acts there as known displacements, or nullptr. */
    const PrescribedDisplacement *
    prescribed_displacement() const;

    /** The name of the section. */
    std::string name;
    /** Where it acts: one of Geometry::boundary_names(). */
    std::string boundary_name;
    /** What acts there. */
    Choice<BoundaryCondition> type;
    /** The id of that boundary, by BoundaryConditions::initialize(). */
    dealii::types::boundary_id boundary = dealii::numbers::invalid_boundary_id;
  };



  /** All loads and supports of a run. */
  class BoundaryConditions : public ParameterOwner
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
     * Find the boundaries and read the expressions. Throws ExcInput for a
     * boundary that does not exist and for two conditions that prescribe the
     * same displacement.
     */
    void
    initialize(const Geometry &geometry);

    /**
     * Try all expressions in the middle of faces they are for, at @p times.
     * Throws ExcInput where a value is NaN or infinite. Collective.
     */
    void
    try_expressions(
      const dealii::parallel::TriangulationBase<dim> &triangulation,
      const std::vector<double>                      &times) const;

    /** How many there are. */
    unsigned int
    n_conditions() const;

    /** Number @p i of n_conditions(), in the order of their names. */
    const NamedCondition &
    condition(const unsigned int i) const;

    /** All loads and prescribed displacements over time; the same on all
     * ranks. */
    std::vector<LoadCurve>
    load_curves(
      const dealii::parallel::TriangulationBase<dim> &triangulation) const;

    /** Which of the conditions are a SurfaceTerm on boundary @p id. */
    const std::vector<unsigned int> &
    surface_terms_on(const dealii::types::boundary_id id) const;

    /** Which of the conditions are a PrescribedDisplacement of boundary
     * @p id. */
    const std::vector<unsigned int> &
    prescribed_displacements_on(const dealii::types::boundary_id id) const;

    /** Whether rigid motions that are left are to be held at three points. */
    bool
    minimal_support() const;

    /** Whether the tangent matrix is symmetric. */
    bool
    symmetric() const;

  private:
    bool                          hold_rigid_motions = true;
    std::vector<std::string>      names;
    NamedSections<NamedCondition> conditions;

    /** Numbers of conditions by where they act. */
    using ByBoundary =
      std::map<dealii::types::boundary_id, std::vector<unsigned int>>;
    ByBoundary surface_terms, prescribed_displacements;
  };
} // namespace lumbricus

#endif
