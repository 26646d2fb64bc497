// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_assembler_h
#define lumbricus_discretization_assembler_h

#include <lumbricus/anatomy/anatomy.h>
#include <lumbricus/discretization/element_kernel.h>
#include <lumbricus/discretization/reference_field.h>
#include <lumbricus/discretization/supports.h>
#include <lumbricus/loads/boundary_conditions.h>

#include <deal.II/fe/fe_values.h>

#include <memory>
#include <vector>

namespace lumbricus
{
  /**
   * The weak form of equilibrium and of the volume constraint,
   *
   *   r_u = int P : Grad du dV - int T . du dA,    r_p = int c dp dV,
   *
   * and its exact linearisation. It sees F, p, the reference map and a law;
   * whether a cell is muscle or liquid it never asks.
   */
  class Assembler
  {
  public:
    /** What there is to say about a residual besides the vector. */
    struct Report
    {
      /** Root of the sum of squares of the nodal forces of all cells: the
       * level of the internal forces before they balance [N]. */
      double force_level = 0.;
      /** The smallest det F at any quadrature point, and where it is. Where
       * it is not positive the vector is not to be used. */
      double       min_J         = 1.;
      unsigned int min_J_segment = 0;

      bool
      valid() const
      {
        return min_J > 0.;
      }
    };

    Assembler(const MixedSpace         &space,
              const ShapeCache         &shapes,
              const Anatomy            &anatomy,
              const BoundaryConditions &conditions,
              const ReferenceField     &references,
              const Supports           &supports);

    /** Set up vectors and the matrix, after every change of the mesh. */
    void
    reinit();

    /** Compute the residual r at @p solution and time @p t. Collective. */
    Report
    residual(const Vector &solution, const double t, Vector &r);

    /**
     * Compute the tangent matrix and the right-hand side -r, with the
     * inhomogeneities of the supports brought to it. Collective.
     */
    Report
    linearise(const Vector &solution, const double t);

    /** Whether the tangent matrix is symmetric under the loads there are. */
    bool
    symmetric() const;

    const Matrix &
    matrix() const;

    const Vector &
    right_hand_side() const;

  private:
    Report
    assemble(const Vector &solution,
             const double  t,
             const bool    with_tangent,
             Vector       &vector);

    /** Copy the kernel's blocks to cell_matrix and cell_vector. */
    void
    gather_blocks(const bool with_tangent);

    /** Subtract the boundary tractions of a cell from both. */
    void
    add_surface_terms(const dealii::DoFHandler<dim>::active_cell_iterator &cell,
                      const double                                         t,
                      const bool with_tangent);

    const MixedSpace         &space;
    const ShapeCache         &shapes;
    const Anatomy            &anatomy;
    const BoundaryConditions &conditions;
    const ReferenceField     &references;
    const Supports           &supports;

    Matrix tangent;
    Vector rhs;
    Vector relevant_solution;

    std::unique_ptr<ElementKernel> kernel;
    dealii::FullMatrix<double>     cell_matrix;
    dealii::Vector<double>         cell_vector;
    dealii::FEFaceValues<dim>      face_values;
  };
} // namespace lumbricus

#endif
