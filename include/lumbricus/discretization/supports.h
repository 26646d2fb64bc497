// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_supports_h
#define lumbricus_discretization_supports_h

#include <lumbricus/discretization/mixed_space.h>
#include <lumbricus/geometry/geometry.h>
#include <lumbricus/loads/boundary_conditions.h>

#include <deal.II/lac/affine_constraints.h>

#include <vector>

namespace lumbricus
{
  /**
   * The constraints on the unknowns: hanging nodes, planes of symmetry,
   * prescribed displacements, and the minimal support. They are constraints
   * on Newton's increments, whose inhomogeneity is what is still missing to
   * the prescribed displacement.
   */
  class Supports
  {
  public:
    Supports(const MixedSpace         &space,
             const Geometry           &geometry,
             const BoundaryConditions &conditions);

    /**
     * Make the constraints, after every change of the mesh. Throws ExcInput
     * where the body can still move rigidly, naming the motions. Collective.
     */
    void
    reinit();

    /**
     * Set the inhomogeneities to what @p solution lacks of the displacements
     * prescribed at time @p t.
     * @return the largest of them on any rank. Collective.
     */
    double
    set_increments(const Vector &solution, const double t);

    /** Set all inhomogeneities to zero. */
    void
    set_increments_to_zero();

    const dealii::AffineConstraints<double> &
    constraints() const;

  private:
    /** An unknown that is prescribed; without a condition it is held at 0. */
    struct Prescribed
    {
      dealii::types::global_dof_index index;
      unsigned int                    component;
      dealii::Point<dim>              X;
      const BoundaryCondition        *condition;
    };

    void
    prescribe_boundaries();

    void
    hold_rigid_motions();

    const MixedSpace         &space;
    const Geometry           &geometry;
    const BoundaryConditions &conditions;

    dealii::AffineConstraints<double> increments;
    std::vector<Prescribed>           prescribed;
  };
} // namespace lumbricus

#endif
