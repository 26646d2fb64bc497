// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_loads_boundary_conditions_h
#define lumbricus_loads_boundary_conditions_h

#include <lumbricus/core/load_curve.h>
#include <lumbricus/core/named_sections.h>
#include <lumbricus/core/registry.h>
#include <lumbricus/geometry/geometry.h>
#include <lumbricus/loads/boundary_condition.h>

#include <deal.II/distributed/tria_base.h>

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

    /** The conditions that act on boundary @p id. */
    std::vector<const BoundaryCondition *>
    on_boundary(const dealii::types::boundary_id id) const;

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
  };
} // namespace lumbricus

#endif
