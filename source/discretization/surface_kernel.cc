// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/same_cell.h>
#include <lumbricus/discretization/surface_kernel.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/fe/fe_update_flags.h>

namespace lumbricus
{
  SurfaceKernel::SurfaceKernel(const MixedSpace                  &space,
                               const dealii::Quadrature<dim - 1> &quadrature)
    : space(space)
    , face_values(space.mapping,
                  space.fe,
                  quadrature,
                  dealii::update_values | dealii::update_gradients |
                    dealii::update_JxW_values | dealii::update_normal_vectors |
                    dealii::update_quadrature_points)
  {}



  SurfaceKernel::SurfaceKernel(const MixedSpace &space)
    : SurfaceKernel(space, space.face_quadrature)
  {}



  void
  SurfaceKernel::reinit(
    const dealii::DoFHandler<dim>::active_cell_iterator &cell,
    const unsigned int                                   face)
  {
    face_values.reinit(mesh_cell(cell), face);
    unsigned int k = 0;
    for (unsigned int n = 0; n < n_nodes; ++n)
      if (space.fe.has_support_on_face(space.displacement_dof[0][n], face))
        face_nodes[k++] = n;
    AssertDimension(k, face_nodes.size());
  }



  unsigned int
  SurfaceKernel::n_points() const
  {
    return face_values.n_quadrature_points;
  }



  void
  SurfaceKernel::set(
    const unsigned int q,
    const double (&node_displacements)[dim][ShapeCache::padded_nodes])
  {
    point = q;
    JxW   = face_values.JxW(q);
    X     = face_values.quadrature_point(q);
    N     = face_values.normal_vector(q);
    u     = 0.;
    F     = dealii::unit_symmetric_tensor<dim, double>();
    for (unsigned int n = 0; n < n_nodes; ++n)
      {
        const unsigned int dof = space.displacement_dof[0][n];
        values[n]              = face_values.shape_value(dof, q);
        gradients[n]           = face_values.shape_grad(dof, q);
        for (unsigned int c = 0; c < dim; ++c)
          {
            u[c] += node_displacements[c][n] * values[n];
            F[c] += node_displacements[c][n] * gradients[n];
          }
      }
  }



  double
  SurfaceKernel::pressure(
    const double (&modes)[MixedSpace::n_pressure_modes]) const
  {
    double p = 0.;
    for (unsigned int m = 0; m < MixedSpace::n_pressure_modes; ++m)
      p += modes[m] * face_values.shape_value(space.pressure_dof[m], point);
    return p;
  }
} // namespace lumbricus
