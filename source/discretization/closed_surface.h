// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_closed_surface_h
#define lumbricus_discretization_closed_surface_h

#include <lumbricus/core/dimension.h>
#include <lumbricus/geometry/geometry.h>
#include <lumbricus/terms/boundary_conditions.h>

#include <deal.II/base/types.h>
#include <deal.II/grid/tria.h>

#include <set>

namespace lumbricus
{
  /**
   * Whether the surface that the @p boundaries make together ends nowhere but at
   * planes of symmetry and at edges that are held in all directions. What a
   * uniform pressure on it does has a potential then, its volume, so that its
   * derivative is symmetric: what an edge adds to the unsymmetric part is
   * int (du X dv) . dl/2, which is zero where du or dv are, and where both lie in one
   * plane with dl. Every rank looks at the coarse cells of all of
   * @p triangulation.
   */
  bool
  is_closed_surface(const std::set<dealii::types::boundary_id> &boundaries,
                    const dealii::Triangulation<dim>           &triangulation,
                    const Geometry                             &geometry,
                    const BoundaryConditions                   &conditions);
} // namespace lumbricus

#endif
