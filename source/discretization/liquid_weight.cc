// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/discretization/element_kernel.h>
#include <lumbricus/discretization/liquid_weight.h>
#include <lumbricus/measures/cavity_volume.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>

#include <array>
#include <string>

namespace lumbricus
{
  LiquidWeight::LiquidWeight(const Body       &body,
                             const BodyForces &forces,
                             const Density    &density)
    : body(body)
    , forces(forces)
    , density(density)
    , cavities(body.anatomy.geometry())
    , walls(body.anatomy.geometry().cavities())
    , surface(body.space, dealii::QGauss<dim - 1>(4))
  {
    for (const SymmetryPlane &plane :
         body.anatomy.geometry().symmetry_planes())
      {
        if (is_symmetry_plane.size() <= plane.boundary)
          is_symmetry_plane.resize(plane.boundary + 1, false);
        is_symmetry_plane[plane.boundary] = true;
      }
  }



  bool
  LiquidWeight::any() const
  {
    for (const auto &gravity : gravities)
      if (gravity.norm_square() > 0.)
        return true;
    return false;
  }



  void
  LiquidWeight::reinit()
  {
    of_segment.assign(body.anatomy.geometry().n_segments(), Chamber());
    gravities.assign(forces.n_forces(), dealii::Tensor<1, dim>());
    if (!gravities.empty())
      of_segment = chambers_at(nullptr);
  }



  std::vector<LiquidWeight::Chamber>
  LiquidWeight::chambers_at(const Vector *relevant_solution)
  {
    const auto           all = moments(relevant_solution);
    std::vector<Chamber> found(all.size());
    for (unsigned int s = 0; s < all.size(); ++s)
      if (all[s][0] > 0.)
        {
          found[s].density = density(s);
          found[s].volume  = all[s][0];
          for (unsigned int c = 0; c < dim; ++c)
            found[s].centre[c] = all[s][1 + c] / all[s][0];
        }
    return found;
  }



  void
  LiquidWeight::check_pistons(const std::vector<double> &times) const
  {
    for (const CavityWall &wall : body.anatomy.geometry().cavities())
      if (!wall.pistons.empty() && of_segment[wall.segment].density > 0.)
        for (unsigned int i = 0; i < forces.n_forces(); ++i)
          for (const double t : times)
            AssertThrow(gravity(i, t).norm() == 0.,
                        ExcInput(
                          "The liquid between pistons in segment " +
                          std::to_string(wall.segment + 1) +
                          " cannot have weight, as the body force '" +
                          forces.force(i).name +
                          "' gives it: the pistons have no points that it could "
                          "press. Set its 'Density' in the section Cavities to "
                          "0, or let it have cells."));
  }



  void
  LiquidWeight::set_time(const LoadTime &t)
  {
    for (unsigned int i = 0; i < gravities.size(); ++i)
      gravities[i] = gravity(i, t);
  }



  dealii::Tensor<1, dim>
  LiquidWeight::gravity(const unsigned int i, const LoadTime &t) const
  {
    const NamedBodyForce &force = forces.force(i);
    return force.tissues.empty() ? force.type->gravity(t) :
                                   dealii::Tensor<1, dim>();
  }



  LiquidWeight::Side
  LiquidWeight::side(const OwnedCell &cell, const unsigned int f) const
  {
    constexpr Side     none{0, 0.};
    const unsigned int cavity = cavities.at(cell, f);
    const unsigned int own    = cell.region.segment;
    if (cavity != CavityFaces::none)
      return {walls[cavity].segment, -1.};
    if (cell.iterator->at_boundary(f))
      {
        const auto id = cell.iterator->face(f)->boundary_id();
        const bool mirror =
          id < is_symmetry_plane.size() && is_symmetry_plane[id];
        return cell.is_liquid && !mirror ? Side{own, 1.} : none;
      }
    if (cell.is_liquid)
      return none;
    auto beyond = cell.iterator->neighbor(f);
    if (beyond->has_children())
      beyond = cell.iterator->neighbor_child_on_subface(f, 0);
    const Region region = Region::of(beyond->material_id());
    return body.anatomy.is_liquid(region.tissue) ? Side{region.segment, -1.} :
                                                   none;
  }



  bool
  LiquidWeight::acts_on(const OwnedCell &cell) const
  {
    if (!any())
      return false;
    for (const unsigned int f : cell.iterator->face_indices())
      {
        const Side at = side(cell, f);
        if (at.sign != 0. && of_segment[at.segment].density > 0.)
          return true;
      }
    return false;
  }



  void
  LiquidWeight::visit(const OwnedCell &cell,
                      const double (&u)[dim][ShapeCache::padded_nodes],
                      const Listener &listener)
  {
    if (!any())
      return;
    for (const unsigned int f : cell.iterator->face_indices())
      {
        const Side at = side(cell, f);
        if (at.sign == 0. || of_segment[at.segment].density == 0.)
          continue;
        const Chamber &chamber = of_segment[at.segment];
        surface.reinit(cell.iterator, f);
        for (unsigned int q = 0; q < surface.n_points(); ++q)
          {
            surface.set(q, u);
            for (unsigned int i = 0; i < gravities.size(); ++i)
              {
                const auto pull = chamber.density * gravities[i];
                listener(i,
                         pull,
                         pull * (surface.X + surface.u - chamber.centre),
                         at.sign);
              }
          }
      }
  }



  double
  LiquidWeight::excess(const unsigned int        segment,
                       const dealii::Point<dim> &x) const
  {
    const Chamber &chamber = of_segment[segment];
    double         q       = 0.;
    for (const auto &gravity : gravities)
      q += chamber.density * gravity * (x - chamber.centre);
    return q;
  }



  std::vector<double>
  LiquidWeight::mean_excess(const Vector &relevant_solution)
  {
    std::vector<double> means(of_segment.size(), 0.);
    if (!any())
      return means;
    const auto all = moments(&relevant_solution);
    for (unsigned int s = 0; s < means.size(); ++s)
      if (of_segment[s].volume > 0.)
        {
          dealii::Point<dim> centre;
          for (unsigned int c = 0; c < dim; ++c)
            centre[c] = all[s][1 + c] / all[s][0];
          means[s] = excess(s, centre);
        }
    return means;
  }



  std::vector<std::array<double, 1 + dim>>
  LiquidWeight::moments(const Vector *relevant_solution)
  {
    std::vector<double> sums((1 + dim) * of_segment.size(), 0.);
    const auto          add = [&](const unsigned int        segment,
                         const dealii::Tensor<1, dim> &first,
                         const double                  volume) {
      double *sum = &sums[(1 + dim) * segment];
      sum[0] += volume;
      for (unsigned int c = 0; c < dim; ++c)
        sum[1 + c] += first[c];
    };
    ElementKernel kernel;
    std::vector<dealii::types::global_dof_index> indices(
      body.space.fe.n_dofs_per_cell());
    const auto read = [&](const OwnedCell &cell) {
      if (relevant_solution != nullptr)
        kernel.read(body.space, cell.iterator, *relevant_solution, indices);
    };
    for (const OwnedCell cell : body.owned_cells())
      if (cell.is_liquid)
        {
          read(cell);
          const ShapeCache::Cell shape = body.shapes.cell(cell.index);
          kernel.compute_deformation(shape);
          for (unsigned int q = 0; q < MixedSpace::n_q_points; ++q)
            {
              const auto x = body.shapes.quadrature_point(cell.index, q) +
                             kernel.displacement(body.shapes.node_values(q));
              const double dv = determinant(kernel.F[q]) * shape.JxW[q];
              add(cell.region.segment, dv * x, dv);
            }
        }
    // int x_c dv = 1/2 int x_c^2 n_c da: planes of symmetry, which have the
    // origin in them, give nothing.
    cavities.for_each(body, [&](const OwnedCell   &cell,
                                const unsigned int f,
                                const unsigned int k) {
      read(cell);
      surface.reinit(cell.iterator, f);
      for (unsigned int q = 0; q < surface.n_points(); ++q)
        {
          surface.set(q, kernel.u);
          const auto   x  = surface.X + surface.u - walls[k].origin;
          const auto   dA = area_out_of_cavity(surface);
          const double dv = volume_in_cavity(surface, walls[k]);
          dealii::Tensor<1, dim> first;
          for (unsigned int c = 0; c < dim; ++c)
            first[c] = 0.5 * x[c] * x[c] * dA[c] + walls[k].origin[c] * dv;
          add(walls[k].segment, first, dv);
        }
    });
    dealii::Utilities::MPI::sum(sums, body.space.communicator(), sums);
    std::vector<std::array<double, 1 + dim>> all(of_segment.size());
    for (unsigned int s = 0; s < all.size(); ++s)
      for (unsigned int i = 0; i <= dim; ++i)
        all[s][i] = sums[(1 + dim) * s + i];
    return all;
  }
} // namespace lumbricus
