// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/cavity_faces.h>
#include <lumbricus/measures/cavity_measures.h>

namespace lumbricus
{
  const std::string cavity_pressure = "cavity_pressure";



  dealii::Tensor<1, dim>
  area_out_of_cavity(const SurfaceKernel &surface)
  {
    return -surface.JxW * (dealii::cofactor(surface.F) * surface.N);
  }



  double
  volume_in_cavity(const SurfaceKernel &surface)
  {
    return (surface.X + surface.u) * area_out_of_cavity(surface) / dim;
  }



  std::vector<double>
  cavity_volumes(const Body &body, const Vector &relevant_solution)
  {
    const CavityFaces   cavities(body.anatomy.geometry());
    std::vector<double> volumes(cavities.size(), 0.);
    if (volumes.empty())
      return volumes;
    const MixedSpace &space   = body.space;
    SurfaceKernel     surface(space);
    double            u[dim][ShapeCache::padded_nodes] = {};
    std::vector<dealii::types::global_dof_index> indices(
      space.fe.n_dofs_per_cell());
    cavities.for_each(body, [&](const OwnedCell   &cell,
                                const unsigned int face,
                                const unsigned int k) {
      cell.iterator->get_dof_indices(indices);
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
          u[c][n] = relevant_solution(indices[space.displacement_dof[c][n]]);
      surface.reinit(cell.iterator, face);
      for (unsigned int q = 0; q < surface.n_points(); ++q)
        {
          surface.set(q, u);
          volumes[k] += volume_in_cavity(surface);
        }
    });
    dealii::Utilities::MPI::sum(volumes, space.communicator(), volumes);
    return volumes;
  }
} // namespace lumbricus
