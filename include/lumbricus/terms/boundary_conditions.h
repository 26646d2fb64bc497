// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_terms_boundary_conditions_h
#define lumbricus_terms_boundary_conditions_h

#include <lumbricus/core/load_curve.h>
#include <lumbricus/geometry/geometry.h>
#include <lumbricus/parameters/named_list.h>
#include <lumbricus/parameters/section.h>
#include <lumbricus/terms/named_term.h>
#include <lumbricus/terms/prescribed_displacement.h>
#include <lumbricus/terms/surface_term.h>

#include <deal.II/distributed/tria_base.h>

#include <map>
#include <string>
#include <vector>

namespace lumbricus
{
  /** One section of Boundary conditions: what acts where. */
  class NamedCondition : public NamedTerm<BoundaryCondition>
  {
  public:
    using NamedTerm::NamedTerm;

    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    /** Find the boundary. Throws ExcInput where there is none of that name. */
    void
    initialize(const std::string &section, const Geometry &geometry) override;

    /** What acts there as a traction, or nullptr. */
    const SurfaceTerm *
    surface_term() const;

    /** What acts there as known displacements, or nullptr. */
    const PrescribedDisplacement *
    prescribed_displacement() const;

    /** Where it acts: one of Geometry::boundary_names(). */
    std::string boundary_name;
    /** The id of that boundary, after initialize(). */
    dealii::types::boundary_id boundary = dealii::numbers::invalid_boundary_id;
  };



  /** All loads and supports of a run. */
  class BoundaryConditions : public Section<NamedList<NamedCondition>>
  {
  public:
    /** None. */
    BoundaryConditions();

    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    /** Initialize all. Throws ExcInput, also for two that prescribe the same
     * displacement. */
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

    /** Tell the surface terms of each boundary what they may measure lengths and
     * stresses by. */
    void
    set_scales(
      const std::map<dealii::types::boundary_id, SurfaceScale> &scales);

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

  private:
    bool hold_rigid_motions = true;

    /** Numbers of conditions by where they act. */
    using ByBoundary =
      std::map<dealii::types::boundary_id, std::vector<unsigned int>>;
    ByBoundary surface_terms, prescribed_displacements;
  };
} // namespace lumbricus

#endif
