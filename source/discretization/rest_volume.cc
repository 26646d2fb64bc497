// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/element_kernel.h>
#include <lumbricus/discretization/rest_volume.h>
#include <lumbricus/reference_map/fluid_reset.h>

#include <deal.II/grid/filtered_iterator.h>

#include <cmath>

namespace lumbricus
{
  namespace
  {
    // Call function(owned_index, segment, indices of rest_dof_handler) for all
    // owned cells of liquid.
    template <typename Function>
    void
    for_each_liquid_cell(const MixedSpace &space,
                         const Anatomy    &anatomy,
                         const Function   &function)
    {
      std::vector<dealii::types::global_dof_index> indices(
        space.rest_fe.n_dofs_per_cell());
      unsigned int cell_index = 0;
      for (const auto &cell : space.rest_dof_handler.active_cell_iterators() |
                                dealii::IteratorFilters::LocallyOwnedCell())
        {
          const unsigned int i      = cell_index++;
          const Region       region = Region::of(cell->material_id());
          if (!anatomy.is_liquid(region.tissue))
            continue;
          cell->get_dof_indices(indices);
          function(i, region.segment, indices);
        }
    }
  } // namespace



  std::vector<double>
  rest_volumes(const MixedSpace &space,
               const ShapeCache &shapes,
               const Anatomy    &anatomy,
               const State      &state)
  {
    std::vector<double> volumes(anatomy.geometry().n_segments(), 0.);
    const Vector       &u_vol = volume_displacement.in(state);
    ElementKernel       kernel;
    for_each_liquid_cell(
      space,
      anatomy,
      [&](const unsigned int i,
          const unsigned int segment,
          const auto        &indices) {
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
            kernel.u[c][n] = u_vol[indices[space.rest_dof[c][n]]];
        kernel.compute_deformation(shapes.cell(i));
        for (unsigned int q = 0; q < MixedSpace::n_q_points; ++q)
          volumes[segment] += determinant(kernel.F[q]) * shapes.cell(i).JxW[q];
      });
    dealii::Utilities::MPI::sum(volumes, space.communicator(), volumes);
    return volumes;
  }



  void
  set_rest_volumes(const std::vector<double> &volumes,
                   const MixedSpace          &space,
                   const ShapeCache          &shapes,
                   const Anatomy             &anatomy,
                   State                     &state)
  {
    const auto present = rest_volumes(space, shapes, anatomy, state);
    Vector    &u_vol   = volume_displacement.in(state);
    for_each_liquid_cell(
      space,
      anatomy,
      [&](const unsigned int i,
          const unsigned int segment,
          const auto        &indices) {
        if (volumes[segment] == present[segment])
          return;
        const double scale = std::cbrt(volumes[segment] / present[segment]);
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
            {
              const double X     = shapes.node(i, n)[c];
              const auto   index = indices[space.rest_dof[c][n]];
              const double u     = u_vol[index];
              u_vol[index]       = scale * (X + u) - X;
            }
      });
    u_vol.compress(dealii::VectorOperation::insert);
  }
} // namespace lumbricus
