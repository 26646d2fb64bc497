// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_surface_tractions_h
#define lumbricus_discretization_surface_tractions_h

#include <lumbricus/core/load_time.h>
#include <lumbricus/core/load_time.h>
#include <lumbricus/discretization/same_cell.h>
#include <lumbricus/discretization/shape_cache.h>
#include <lumbricus/loads/boundary_conditions.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/fe/fe_update_flags.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>

namespace lumbricus
{
  /** The nodes of a cell, as a quadrature point of its surface sees them. */
  struct SurfaceNodes
  {
    double                 JxW;                           ///< [mm^2]
    double                 values[MixedSpace::n_nodes];    ///< N_n
    dealii::Tensor<1, dim> gradients[MixedSpace::n_nodes]; ///< dN_n/dX [1/mm]
    dealii::Point<dim>     x; ///< the point, X + u [mm]

    /** What FEFaceValues have to compute for it. */
    static dealii::UpdateFlags
    update_flags()
    {
      return dealii::update_values | dealii::update_gradients |
             dealii::update_JxW_values | dealii::update_normal_vectors |
             dealii::update_quadrature_points;
    }
  };



  /**
   * Call function(condition, nodes, response) at the quadrature points of all
   * faces of @p cell at the boundary, for every traction that acts there:
   * SurfaceNodes and the SurfaceResponse at the displacements @p u, [i][n], and
   * time @p t.
   */
  template <typename Function>
  void
  for_each_traction(const MixedSpace         &space,
                    const BoundaryConditions &conditions,
                    const dealii::DoFHandler<dim>::active_cell_iterator &cell,
                    const double (&u)[dim][ShapeCache::padded_nodes],
                    const LoadTime            &t,
                    dealii::FEFaceValues<dim> &face_values,
                    const Function            &function)
  {
    for (const auto &face : cell->face_iterators())
      {
        if (!face->at_boundary())
          continue;
        auto acting = conditions.on_boundary(face->boundary_id());
        acting.erase(std::remove_if(acting.begin(),
                                    acting.end(),
                                    [](const BoundaryCondition *condition) {
                                      return !condition->acts_on_surface();
                                    }),
                     acting.end());
        if (acting.empty())
          continue;

        face_values.reinit(mesh_cell(cell), face);
        for (const unsigned int q : face_values.quadrature_point_indices())
          {
            SurfacePoint point;
            point.X = face_values.quadrature_point(q);
            point.N = face_values.normal_vector(q);
            point.t = t;
            point.F = dealii::unit_symmetric_tensor<dim, double>();

            SurfaceNodes nodes;
            nodes.JxW = face_values.JxW(q);
            for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
              {
                const unsigned int dof = space.displacement_dof[0][n];
                nodes.gradients[n]     = face_values.shape_grad(dof, q);
                nodes.values[n]        = face_values.shape_value(dof, q);
                for (unsigned int c = 0; c < dim; ++c)
                  {
                    point.u[c] += u[c][n] * nodes.values[n];
                    for (unsigned int J = 0; J < dim; ++J)
                      point.F[c][J] += u[c][n] * nodes.gradients[n][J];
                  }
              }
            nodes.x = point.X + point.u;

            for (const BoundaryCondition *condition : acting)
              {
                SurfaceResponse response;
                condition->surface(point, response);
                function(*condition, nodes, response);
              }
          }
      }
  }
} // namespace lumbricus

#endif
