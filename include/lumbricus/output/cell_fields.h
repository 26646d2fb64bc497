// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_output_cell_fields_h
#define lumbricus_output_cell_fields_h

#include <lumbricus/output/field.h>

#include <deal.II/base/point.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace lumbricus
{
  /** A field of the body at hand; several for one that is per muscle. */
  struct FieldArray
  {
    std::string   name;   ///< the only one of this name
    const Field  *field;  ///< what it is
    const Muscle *muscle; ///< null for a field that is not per muscle
  };



  /** A cell that is there in pictures only, with values at its nodes, x fastest. */
  struct FillingCell
  {
    std::array<dealii::Point<dim>, MixedSpace::n_nodes> X; ///< at rest [mm]
    /** Of the nodal arrays: [component * n_nodes + node]. */
    std::vector<double> nodal;
    std::vector<double> per_cell; ///< of the arrays per cell
  };



  /**
   * The values of fields on the mesh. On each cell they are the triquadratic
   * function that takes the values at the quadrature points: discontinuous
   * between cells, as stresses are between tissues; the displacement is what
   * it is. Those per cell are a number each.
   */
  class CellFields
  {
  public:
    /** For @p arrays; there is nothing to see before reinit() and update().
     * All of these are kept by reference, but for the list of arrays. */
    CellFields(const Body                    &body,
               const ReferenceField          &references,
               const LiquidWeight            &weight,
               const BoundaryConditions      &conditions,
               const std::vector<FieldArray> &arrays);

    /** After every change of the mesh. Collective. */
    void
    reinit();

    /** Compute all at @p state, which the references are of. Collective. */
    void
    update(const State &state);

    /** What there is a value of at every node, in the order of the components
     * of values(): each has Field::n_components(). */
    const std::vector<FieldArray> &
    nodal_arrays() const;

    /** What there is one value of on every cell. */
    const std::vector<FieldArray> &
    cell_arrays() const;

    /** The components of the nodal array @p name, which has to be there. */
    std::vector<unsigned int>
    components(const std::string &name) const;

    /** That of values(): as many FE_DGQ(2) as there are components. */
    const dealii::DoFHandler<dim> &
    dof_handler() const;

    /** Of the nodal arrays, ghosted. */
    const Vector &
    values() const;

    /** Of number @p i of cell_arrays(), by the active cells' indices; zero on
     * cells of other ranks. */
    const dealii::Vector<double> &
    cell_values(const unsigned int i) const;

    /** Cells of this rank that fill chambers without cells, see
     * visit_cavity_points(). */
    const std::vector<FillingCell> &
    filling_cells() const;

    /** Where they are. */
    const Body body;

  private:
    void
    update_filling_cells(const State &state);

    /** The values of each SurfaceField. */
    void
    update_skin(const State &state);

    /** Write the values of the nodal arrays at @p point from @p next on. */
    void
    get_nodal(FieldPoint &point, double *next) const;

    const ReferenceField &references;
    const LiquidWeight   &weight;
    const BoundaryConditions &conditions;

    std::vector<FieldArray> nodal;
    std::vector<FieldArray> per_cell;

    std::unique_ptr<dealii::FESystem<dim>> fe;
    dealii::DoFHandler<dim>                fields_dof_handler;
    dealii::FullMatrix<double>             projection;
    Vector                                 field_values;
    std::vector<dealii::Vector<double>>    values_per_cell;
    std::vector<FillingCell>               filling;
  };
} // namespace lumbricus

#endif
