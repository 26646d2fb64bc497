// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_surface_tractions_h
#define lumbricus_discretization_surface_tractions_h

#include <lumbricus/core/load_time.h>
#include <lumbricus/discretization/surface_kernel.h>
#include <lumbricus/loads/boundary_conditions.h>

#include <algorithm>

namespace lumbricus
{
  /**
   * Call function(condition, response) at the quadrature points of all faces of
   * @p cell at the boundary, for every traction that acts there, with its
   * SurfaceResponse at the displacements @p u, [i][n], and time @p t. @p surface
   * is at the point then.
   */
  template <typename Function>
  void
  for_each_traction(const BoundaryConditions &conditions,
                    const dealii::DoFHandler<dim>::active_cell_iterator &cell,
                    const double (&u)[dim][ShapeCache::padded_nodes],
                    const LoadTime &t,
                    SurfaceKernel  &surface,
                    const Function &function)
  {
    for (const unsigned int f : cell->face_indices())
      {
        if (!cell->at_boundary(f))
          continue;
        auto acting = conditions.on_boundary(cell->face(f)->boundary_id());
        acting.erase(std::remove_if(acting.begin(),
                                    acting.end(),
                                    [](const BoundaryCondition *condition) {
                                      return !condition->acts_on_surface();
                                    }),
                     acting.end());
        if (acting.empty())
          continue;

        surface.reinit(cell, f);
        for (unsigned int q = 0; q < surface.n_points(); ++q)
          {
            surface.set(q, u);
            const SurfacePoint point{
              surface.X, surface.N, surface.u, surface.F, t};
            for (const BoundaryCondition *condition : acting)
              {
                SurfaceResponse response;
                condition->surface(point, response);
                function(*condition, response);
              }
          }
      }
  }
} // namespace lumbricus

#endif
