// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_loaded_points_h
#define lumbricus_discretization_loaded_points_h

#include <lumbricus/discretization/mixed_space.h>
#include <lumbricus/terms/boundary_conditions.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>

#include <vector>

namespace lumbricus
{
  /** A quadrature point of the boundary at rest where a SurfaceTerm acts: a node
   * where that remembers. */
  struct LoadedPoint
  {
    unsigned int               condition; ///< number of the condition
    dealii::types::material_id material;  ///< of the cell behind
    dealii::Point<dim>         X;         ///< where [mm]
    dealii::Tensor<1, dim>     N;         ///< outward normal
    double                     JxW;       ///< area [mm^2]
    dealii::Tensor<1, dim>     history;   ///< what it remembers at rest

    /** As a SurfaceTerm sees it, at rest and at time zero. */
    SurfacePoint
    at_rest() const;
  };

  /** The points of all owned cells; a point is listed once for every condition
   * that acts on it. */
  std::vector<LoadedPoint>
  loaded_points(const MixedSpace         &space,
                const BoundaryConditions &conditions);
} // namespace lumbricus

#endif
