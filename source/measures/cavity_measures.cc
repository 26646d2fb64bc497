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

namespace lumbricus
{
  const std::string cavity_pressure = "cavity_pressure";



  namespace
  {
    using Point = dealii::Tensor<1, dim>;

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
  } // namespace



  dealii::Tensor<1, dim>
  SectionLine::area() const
  {
    return (forwards ? 1. : -1.) * area_beside(x[0], x[1], x[2]);
  }



  void
  for_each_section_line(const Body                     &body,
                        const Vector                   &relevant_solution,
                        const AtSectionLine &f)
  {
    const Geometry    &geometry = body.anatomy.geometry();
    const auto         walls    = geometry.cavities();
    if (walls.empty())
      return;
    const CavityFaces cavities(geometry);
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
      // The edge of the face, or the line through its middle, which lies in the
      // plane X = middle. Vertices come first, then the middles of lines, then
      // those of faces.
      std::vector<unsigned int> nodes;
      for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
        if (space.fe.has_support_on_face(space.displacement_dof[0][n], face) &&
            std::abs(body.shapes.node(cell.index, n)[0] - middle) < tolerance)
          nodes.push_back(n);
      if (nodes.size() != 3)
        return;
      kernel.read(space, cell.iterator, relevant_solution, indices);
      SectionLine line;
      line.nodes = {{nodes[0], nodes[2], nodes[1]}};
      for (unsigned int i = 0; i < line.nodes.size(); ++i)
        for (unsigned int c = 0; c < dim; ++c)
          line.x[i][c] = body.shapes.node(cell.index, line.nodes[i])[c] +
                         kernel.u[c][line.nodes[i]];
      surface.reinit(cell.iterator, face);
      surface.set(surface.n_points() / 2, at_rest);
      const Point towards_tail({1., 0., 0.});
      line.forwards = dealii::cross_product_3d(towards_tail, -surface.N) *
                        (body.shapes.node(cell.index, nodes[1]) -
                         body.shapes.node(cell.index, nodes[0])) >
                      0.;
      f(cell, k, line);
    });
  }



  std::vector<dealii::Tensor<1, dim>>
  cavity_sections(const Body &body, const Vector &relevant_solution)
  {
    std::vector<Point> areas(body.anatomy.geometry().cavities().size());
    if (areas.empty())
      return areas;
    for_each_section_line(body,
                          relevant_solution,
                          [&areas](const OwnedCell & /*cell*/,
                                   const unsigned int k,
                                   const SectionLine &line) {
                            areas[k] += line.area();
                          });

    std::vector<double> flat;
    for (const Point &area : areas)
      for (unsigned int c = 0; c < dim; ++c)
        flat.push_back(area[c]);
    dealii::Utilities::MPI::sum(flat, body.space.communicator(), flat);
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
