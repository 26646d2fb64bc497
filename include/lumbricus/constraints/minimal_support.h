// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_constraints_minimal_support_h
#define lumbricus_constraints_minimal_support_h

#include <lumbricus/constraints/rigid_motions.h>
#include <lumbricus/discretization/mixed_space.h>
#include <lumbricus/geometry/geometry.h>
#include <lumbricus/terms/boundary_conditions.h>

#include <deal.II/base/point.h>
#include <deal.II/base/types.h>
#include <deal.II/dofs/dof_handler.h>

#include <functional>
#include <vector>

namespace lumbricus
{
  /**
   * The fewest displacements of points that hold a body which nothing else
   * holds, where the user asks for them: loads in balance leave them without
   * force.
   */
  class MinimalSupport
  {
  public:
    /** A displacement that the minimal support holds. */
    struct HeldPoint
    {
      dealii::Point<dim> X;         ///< where [mm]
      unsigned int       direction; ///< 0, 1, 2 for x, y, z
    };

    /** Both arguments are kept by reference. */
    MinimalSupport(const Geometry           &geometry,
                   const BoundaryConditions &conditions);

    /**
     * What holds those motions of the wall that are free in @p motions, which
     * are held there then. Throws ExcInput where the wall can still move
     * rigidly, naming the motions. Equal on all ranks.
     */
    std::vector<HeldPoint>
    of_wall(RigidMotions &motions) const;

    /** What holds the free @p motions of the liquid of a segment that slips
     * along the wall, at @p X, as of_wall() does. */
    std::vector<HeldPoint>
    of_liquid(RigidMotions             &motions,
              const unsigned int        segment,
              const dealii::Point<dim> &X) const;

    /** Whether the minimal support may hold the vertex of a cell whose first
     * displacement is the unknown. */
    using MayHold =
      std::function<bool(const dealii::DoFHandler<dim>::active_cell_iterator &,
                         const dealii::types::global_dof_index)>;

    /** The vertex with the largest y, z, x of those that @p may_hold, equal on
     * any number of ranks. Collective. */
    static dealii::Point<dim>
    outermost_vertex(const MixedSpace &space, const MayHold &may_hold);

  private:
    const Geometry           &geometry;
    const BoundaryConditions &conditions;
  };
} // namespace lumbricus

#endif
