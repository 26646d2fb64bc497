// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/element_kernel.h>
#include <lumbricus/discretization/same_cell.h>
#include <lumbricus/measures/rest_volume.h>
#include <lumbricus/reference_map/fluid_reset.h>

#include <cmath>

namespace lumbricus
{
  namespace
  {
    // Call function(cell, indices of rest_dof_handler) for all owned cells of
    // liquid.
    template <typename Function>
    void
    for_each_liquid_cell(const Body &body, const Function &function)
    {
      const auto &rest_dof_handler = body.space.rest_dof_handler;
      std::vector<dealii::types::global_dof_index> indices(
        body.space.rest_fe.n_dofs_per_cell());
      for (const OwnedCell cell : body.owned_cells())
        {
          if (!cell.is_liquid)
            continue;
          same_cell(cell.iterator, rest_dof_handler)->get_dof_indices(indices);
          function(cell, indices);
        }
    }
  } // namespace



  std::vector<double>
  rest_volumes(const Body &body, const State &state)
  {
    const MixedSpace   &space = body.space;
    std::vector<double> volumes(body.anatomy.geometry().n_segments(), 0.);
    const Vector       &u_vol = volume_displacement.in(state);
    ElementKernel       kernel;
    for_each_liquid_cell(body, [&](const OwnedCell &cell, const auto &indices) {
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
          kernel.u[c][n] = u_vol[indices[space.rest_dof[c][n]]];
      const ShapeCache::Cell shape = body.shapes.cell(cell.index);
      kernel.compute_deformation(shape);
      for (unsigned int q = 0; q < MixedSpace::n_q_points; ++q)
        volumes[cell.region.segment] += determinant(kernel.F[q]) * shape.JxW[q];
    });
    dealii::Utilities::MPI::sum(volumes, space.communicator(), volumes);
    return volumes;
  }



  void
  set_rest_volumes(const std::vector<double> &volumes,
                   const Body                &body,
                   State                     &state)
  {
    const auto present = rest_volumes(body, state);
    Vector    &u_vol   = volume_displacement.in(state);
    for_each_liquid_cell(body, [&](const OwnedCell &cell, const auto &indices) {
      const unsigned int segment = cell.region.segment;
      if (volumes[segment] == present[segment])
        return;
      const double scale = std::cbrt(volumes[segment] / present[segment]);
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
          {
            const double X     = body.shapes.node(cell.index, n)[c];
            const auto   index = indices[body.space.rest_dof[c][n]];
            const double u     = u_vol[index];
            u_vol[index]       = scale * (X + u) - X;
          }
    });
  }
} // namespace lumbricus
