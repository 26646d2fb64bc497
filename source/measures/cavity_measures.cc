// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/cavity_faces.h>
#include <lumbricus/discretization/element_kernel.h>
#include <lumbricus/measures/cavity_measures.h>
#include <lumbricus/measures/cavity_volume.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace lumbricus
{
  const std::string cavity_pressure = "cavity_pressure";



  namespace
  {
    using Point = dealii::Tensor<1, dim>;

    // Where the nodes of a cell are.
    struct Nodes
    {
      std::array<Point, MixedSpace::n_nodes> X; // at rest
      std::array<Point, MixedSpace::n_nodes> x;
    };



    // 1/2 int x X dx along the parabola through three points, of which the
    // second is halfway.
    Point
    area_beside(const Point &a, const Point &m, const Point &b)
    {
      const dealii::QGauss<1> rule(2); // exact
      Point                   area;
      for (unsigned int q = 0; q < rule.size(); ++q)
        {
          const double s  = rule.point(q)[0];
          const Point  x  = (1. - s) * (1. - 2. * s) * a +
                          4. * s * (1. - s) * m + s * (2. * s - 1.) * b;
          const Point dx = (4. * s - 3.) * a + (4. - 8. * s) * m +
                           (4. * s - 1.) * b;
          area += 0.5 * rule.weight(q) * dealii::cross_product_3d(x, dx);
        }
      return area;
    }



    // That beside the edge of a face, or the line through its middle, which lies
    // in the plane X = middle, if there is one, with the wall's normal N at rest.
    Point
    area_beside(const Nodes                     &nodes,
                const std::vector<unsigned int> &on_face,
                const double                     middle,
                const double                     tolerance,
                const Point                     &N)
    {
      // Vertices come first, then the middles of lines, then those of faces.
      std::vector<unsigned int> edge;
      for (const unsigned int n : on_face)
        if (std::abs(nodes.X[n][0] - middle) < tolerance)
          edge.push_back(n);
      if (edge.size() != 3)
        return Point();
      const auto [a, b, m] = std::tie(edge[0], edge[1], edge[2]);
      const Point towards_tail({1., 0., 0.});
      const bool  forwards =
        dealii::cross_product_3d(towards_tail, -N) *
          (nodes.X[b] - nodes.X[a]) >
        0.;
      return (forwards ? 1. : -1.) *
             area_beside(nodes.x[a], nodes.x[m], nodes.x[b]);
    }
  } // namespace



  std::vector<dealii::Tensor<1, dim>>
  cavity_sections(const Body &body, const Vector &relevant_solution)
  {
    const Geometry    &geometry = body.anatomy.geometry();
    const auto         walls    = geometry.cavities();
    const CavityFaces  cavities(geometry);
    std::vector<Point> areas(cavities.size());
    if (areas.empty())
      return areas;
    const MixedSpace &space     = body.space;
    const auto        sections  = geometry.sections();
    const double      tolerance = 1e-9 * geometry.characteristic_length();
    SurfaceKernel     surface(space);
    ElementKernel     kernel;
    const double      at_rest[dim][ShapeCache::padded_nodes] = {};
    std::vector<dealii::types::global_dof_index> indices(
      space.fe.n_dofs_per_cell());
    cavities.for_each(body, [&](const OwnedCell   &cell,
                                const unsigned int face,
                                const unsigned int k) {
      const double middle = sections[walls[k].segment].middle;
      // An edge has a face on either side; a line through a face has one.
      if (cell.iterator->face(face)->center()[0] > middle + tolerance)
        return;
      kernel.read(space, cell.iterator, relevant_solution, indices);
      Nodes                     nodes;
      std::vector<unsigned int> on_face;
      for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
        {
          nodes.X[n] = body.shapes.node(cell.index, n);
          for (unsigned int c = 0; c < dim; ++c)
            nodes.x[n][c] = nodes.X[n][c] + kernel.u[c][n];
          if (space.fe.has_support_on_face(space.displacement_dof[0][n], face))
            on_face.push_back(n);
        }
      surface.reinit(cell.iterator, face);
      surface.set(surface.n_points() / 2, at_rest);
      areas[k] += area_beside(nodes, on_face, middle, tolerance, surface.N);
    });

    std::vector<double> flat;
    for (const Point &area : areas)
      for (unsigned int c = 0; c < dim; ++c)
        flat.push_back(area[c]);
    dealii::Utilities::MPI::sum(flat, space.communicator(), flat);
    for (unsigned int k = 0; k < areas.size(); ++k)
      for (unsigned int c = 0; c < dim; ++c)
        areas[k][c] = flat[dim * k + c];
    return areas;
  }



  std::vector<double>
  cavity_volumes(const Body &body, const Vector &relevant_solution)
  {
    const auto          walls = body.anatomy.geometry().cavities();
    const CavityFaces   cavities(body.anatomy.geometry());
    std::vector<double> volumes(cavities.size(), 0.);
    if (volumes.empty())
      return volumes;
    const MixedSpace &space   = body.space;
    SurfaceKernel     surface(space);
    ElementKernel     kernel;
    std::vector<dealii::types::global_dof_index> indices(
      space.fe.n_dofs_per_cell());
    cavities.for_each(body, [&](const OwnedCell   &cell,
                                const unsigned int face,
                                const unsigned int k) {
      kernel.read(space, cell.iterator, relevant_solution, indices);
      surface.reinit(cell.iterator, face);
      for (unsigned int q = 0; q < surface.n_points(); ++q)
        {
          surface.set(q, kernel.u);
          volumes[k] += volume_in_cavity(surface, walls[k]);
        }
    });
    dealii::Utilities::MPI::sum(volumes, space.communicator(), volumes);
    return volumes;
  }



  Vector
  cavity_volume_derivative(const Body                      &body,
                           const CellUnknowns              &unknowns,
                           const std::vector<unsigned int> &segments,
                           const Vector                    &relevant_solution)
  {
    const auto        walls = body.anatomy.geometry().cavities();
    const CavityFaces cavities(body.anatomy.geometry());
    const MixedSpace &space = body.space;
    SurfaceKernel     surface(space);
    ElementKernel     kernel;
    Vector            derivative;
    std::vector<dealii::types::global_dof_index> indices(
      space.fe.n_dofs_per_cell());
    unknowns.reinit_vector(derivative);
    cavities.for_each(body, [&](const OwnedCell   &cell,
                                const unsigned int face,
                                const unsigned int k) {
      if (std::find(segments.begin(), segments.end(), walls[k].segment) ==
          segments.end())
        return;
      kernel.read(space, cell.iterator, relevant_solution, indices);
      surface.reinit(cell.iterator, face);
      std::array<double, CellUnknowns::n_per_cell> of_cell = {};
      for (unsigned int q = 0; q < surface.n_points(); ++q)
        {
          surface.set(q, kernel.u);
          add_volume_derivative(surface, walls[k], of_cell.data());
        }
      unknowns.add(cell.index, of_cell.data(), derivative);
    });
    derivative.compress(dealii::VectorOperation::add);
    return derivative;
  }
} // namespace lumbricus
