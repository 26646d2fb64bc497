// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_cell_fields_h
#define lumbricus_discretization_cell_fields_h

#include <lumbricus/anatomy/anatomy.h>
#include <lumbricus/discretization/reference_field.h>
#include <lumbricus/discretization/shape_cache.h>

#include <deal.II/fe/fe_system.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/numerics/data_component_interpretation.h>

#include <memory>
#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * All fields for pictures: on each cell the triquadratic function that takes
   * their values at the quadrature points. Discontinuous between cells, as
   * stresses are between tissues; the displacement is what it is.
   */
  class CellFields
  {
  public:
    /** The first components of displacement and Cauchy stress. */
    static constexpr unsigned int displacement_component = 0;
    /** That of the Cauchy stress; the pressure is in between. */
    static constexpr unsigned int stress_component = dim + 1;

    /** Names the fields, by the muscles of @p anatomy; there is nothing to see
     * before reinit() and update(). */
    CellFields(const MixedSpace     &space,
               const ShapeCache     &shapes,
               const Anatomy        &anatomy,
               const ReferenceField &references);

    /** After every change of the mesh. */
    void
    reinit();

    /** Compute all fields at @p solution. */
    void
    update(const Vector &solution);

    /** One per component: displacement (3), pressure, Cauchy stress (9), J,
     * hydrostatic divergence, of every muscle the deformed fibre (3) and the
     * activation (its active stretch), and the pressure variable p. */
    const std::vector<std::string> &
    names() const;

    /**
     * One per component: whether it is a scalar or part of a vector or tensor.
     */
    const std::vector<
      dealii::DataComponentInterpretation::DataComponentInterpretation> &
    interpretations() const;

    /** That of values(): as many FE_DGQ(2) as there are names(). */
    const dealii::DoFHandler<dim> &
    dof_handler() const;

    /** Ghosted. */
    const Vector &
    values() const;

  private:
    /** Add @p n components of the same name. */
    void
    add(const std::string &name,
        const dealii::DataComponentInterpretation::DataComponentInterpretation
                           kind,
        const unsigned int n);

    const MixedSpace     &space;
    const ShapeCache     &shapes;
    const Anatomy        &anatomy;
    const ReferenceField &references;

    std::vector<std::string> component_names;
    std::vector<
      dealii::DataComponentInterpretation::DataComponentInterpretation>
      component_interpretations;

    std::unique_ptr<dealii::FESystem<dim>> fe;
    dealii::DoFHandler<dim>                fields_dof_handler;
    dealii::FullMatrix<double>             projection;
    Vector                                 field_values;
  };
} // namespace lumbricus

#endif
