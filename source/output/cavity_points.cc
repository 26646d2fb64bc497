// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cavity_points.h"

#include <lumbricus/discretization/cavity_faces.h>
#include <lumbricus/discretization/element_kernel.h>
#include <lumbricus/discretization/surface_kernel.h>
#include <lumbricus/measures/cavity_measures.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace lumbricus
{
  const std::string cavity_tissue = "cavity";



  unsigned int
  tissue_of_cavities(const Geometry &geometry)
  {
    const auto tissues = geometry.tissues();
    return std::find_if(tissues.begin(),
                        tissues.end(),
                        [](const TissueName &tissue) {
                          return tissue.liquid;
                        }) -
           tissues.begin();
  }



  namespace
  {
    using Vector3 = dealii::Tensor<1, dim>;

    constexpr unsigned int n_face_nodes = 9;



    // The nodes of a cell on face f, such that the two directions in which they
    // are counted and the normal out of the cell are right-handed.
    std::array<unsigned int, n_face_nodes>
    nodes_of_face(const MixedSpace &space, const unsigned int f)
    {
      const unsigned int normal = f / 2;
      const unsigned int first  = (normal + (f % 2 == 1 ? 1 : 2)) % dim;
      const unsigned int second = dim - normal - first;
      std::array<unsigned int, n_face_nodes> nodes;
      for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
        {
          const unsigned int i = space.displacement_dof[0][n];
          if (!space.fe.has_support_on_face(i, f))
            continue;
          const auto         x     = space.fe.unit_support_point(i);
          const unsigned int place =
            std::round(2. * x[first] + 6. * x[second]);
          nodes[place] = n;
        }
      return nodes;
    }



    // Where a chamber has its middle, and how that moves.
    struct Middle
    {
      Vector3 X, u;
    };



    // The mean of the wall at rest around each chamber, in the planes of symmetry.
    std::vector<Middle>
    middles_of(const std::vector<CavityWall> &walls,
               const CavityFaces             &cavities,
               const Body                    &body,
               const Vector                  &relevant)
    {
      constexpr unsigned int n_sums = 1 + 2 * dim;
      std::vector<double>    sums(n_sums * walls.size(), 0.);
      SurfaceKernel          surface(body.space);
      ElementKernel          kernel;
      std::vector<dealii::types::global_dof_index> indices(
        body.space.fe.n_dofs_per_cell());
      cavities.for_each(body, [&](const OwnedCell   &cell,
                                  const unsigned int face,
                                  const unsigned int k) {
        kernel.read(body.space, cell.iterator, relevant, indices);
        surface.reinit(cell.iterator, face);
        double *sum = &sums[n_sums * k];
        for (unsigned int q = 0; q < surface.n_points(); ++q)
          {
            surface.set(q, kernel.u);
            sum[0] += surface.JxW;
            for (unsigned int c = 0; c < dim; ++c)
              {
                sum[1 + c] += surface.JxW * surface.X[c];
                sum[1 + dim + c] += surface.JxW * surface.u[c];
              }
          }
      });
      dealii::Utilities::MPI::sum(sums, body.space.communicator(), sums);

      std::vector<Middle> middles(walls.size());
      for (unsigned int k = 0; k < walls.size(); ++k)
        {
          const double *sum = &sums[n_sums * k];
          for (unsigned int c = 0; c < dim; ++c)
            {
              middles[k].X[c] = sum[1 + c] / sum[0];
              middles[k].u[c] = sum[1 + dim + c] / sum[0];
            }
          for (const SymmetryPlane &plane :
               body.anatomy.geometry().symmetry_planes())
            {
              middles[k].X[plane.direction] = walls[k].origin[plane.direction];
              middles[k].u[plane.direction] = 0.;
            }
        }
      return middles;
    }
  } // namespace



  void
  visit_cavity_points(const Body                              &body,
                      const LiquidWeight                      &weight,
                      const State                             &state,
                      const std::function<void(FieldPoint &)> &visit)
  {
    const Geometry &geometry = body.anatomy.geometry();
    const auto      walls    = geometry.cavities();
    if (walls.empty())
      return;
    const MixedSpace   &space = body.space;
    const CavityFaces   cavities(geometry);
    const Vector        relevant = space.with_ghosts(state.solution);
    const auto          middles = middles_of(walls, cavities, body, relevant);
    const auto          volumes = cavity_volumes(body, relevant);
    Vector              at_rest(relevant);
    at_rest = 0.;
    at_rest.update_ghost_values(); // they are there, but not known to be
    const auto volumes_at_rest = cavity_volumes(body, at_rest);

    const MaterialPoint passive;
    FieldPoint          point;
    point.t         = state.time;
    point.tissue    = tissue_of_cavities(geometry);
    point.is_liquid = true;
    point.reference = &passive;

    ElementKernel                                kernel;
    std::vector<dealii::types::global_dof_index> indices(
      space.fe.n_dofs_per_cell());
    cavities.for_each(body, [&](const OwnedCell   &cell,
                                const unsigned int face,
                                const unsigned int k) {
      const auto   unit = dealii::unit_symmetric_tensor<dim, double>();
      const double P    = state.globals.at(cavity_pressure)[k];
      point.cell        = cell.iterator;
      point.segment     = walls[k].segment + 1;
      point.J           = volumes[k] / volumes_at_rest[k];
      point.F           = std::cbrt(point.J) * unit;
      point.pressure_unknown = -P;

      kernel.read(space, cell.iterator, relevant, indices);
      const auto nodes = nodes_of_face(space, face);
      for (point.q = 0; point.q < MixedSpace::n_nodes; ++point.q)
        {
          const unsigned int n = nodes[point.q % n_face_nodes];
          const Vector3      X = body.shapes.node(cell.index, n);
          Vector3            u;
          for (unsigned int c = 0; c < dim; ++c)
            u[c] = kernel.u[c][n];
          // Nothing shrinks along the axis where pistons close the chamber.
          Middle to = middles[k];
          if (!walls[k].pistons.empty())
            {
              to.X[0] = X[0];
              to.u[0] = u[0];
            }
          const double part = 0.5 * (point.q / n_face_nodes);
          point.X           = dealii::Point<dim>(X + part * (to.X - X));
          point.u           = u + part * (to.u - u);
          point.pressure =
            P + weight.excess(walls[k].segment, point.X + point.u);
          point.sigma = -point.pressure * unit;
          visit(point);
        }
    });
  }
} // namespace lumbricus
