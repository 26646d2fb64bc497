// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/cavities/cavities.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/discretization/area_derivative.h>
#include <lumbricus/discretization/element_kernel.h>
#include <lumbricus/measures/cavity_measures.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>
#include <string>

namespace lumbricus
{
  namespace
  {
    // Of the sum of its area vectors, relative to its area.
    constexpr double closed = 1e-10;
  } // namespace



  Cavities::Cavities(const Body                  &body,
                     const CellUnknowns          &unknowns,
                     const Choice<CavityContent> &content)
    : body(body)
    , unknowns(unknowns)
    , content(content)
    , faces(body.anatomy.geometry())
    , surface(body.space)
  {}



  void
  Cavities::reinit()
  {
    walls.clear();
    const Geometry &geometry = body.anatomy.geometry();
    for (const CavityWall &wall : geometry.cavities())
      {
        walls.emplace_back();
        walls.back().segment = wall.segment;
      }
    if (!any())
      return;

    // For each wall its volume, its area and the sum of its area vectors; then
    // the volume of the solid.
    constexpr unsigned int n_sums = 2 + dim;
    std::vector<double>    sums(n_sums * walls.size() + 1);
    const double at_rest[dim][ShapeCache::padded_nodes] = {};
    for (unsigned int i = 0; i < body.shapes.n_owned_cells(); ++i)
      for (unsigned int q = 0; q < MixedSpace::n_q_points; ++q)
        sums.back() += body.shapes.cell(i).JxW[q];
    faces.for_each(body,
                   [&](const OwnedCell   &cell,
                       const unsigned int f,
                       const unsigned int k) {
                     walls[k].faces.push_back({cell.index, cell.iterator, f});
                     surface.reinit(cell.iterator, f);
                     double *sum = &sums[n_sums * k];
                     for (unsigned int q = 0; q < surface.n_points(); ++q)
                       {
                         surface.set(q, at_rest);
                         sum[0] += volume_in_cavity(surface);
                         sum[1] += surface.JxW;
                         for (unsigned int c = 0; c < dim; ++c)
                           sum[2 + c] += area_out_of_cavity(surface)[c];
                       }
                   });
    dealii::Utilities::MPI::sum(sums, body.space.communicator(), sums);

    body_volume = sums.back();
    for (unsigned int k = 0; k < walls.size(); ++k)
      {
        double *sum             = &sums[n_sums * k];
        walls[k].volume_at_rest = sum[0];
        body_volume += sum[0];
        // A plane of symmetry closes it there.
        for (const SymmetryPlane &plane : geometry.symmetry_planes())
          sum[2 + plane.direction] = 0.;
        const dealii::Tensor<1, dim> open({sum[2], sum[3], sum[4]});
        if (open.norm() > closed * sum[1] || !(sum[0] > 0.))
          {
            std::ostringstream message;
            message << "The cavity of segment " << walls[k].segment + 1
                    << " is not closed: the area vectors of its "
                    << "wall add up to (" << open << ") mm^2, and it holds "
                    << sum[0] << " mm^3. Which surface is missing?";
            AssertThrow(false, ExcInput(message.str()));
          }
      }
  }



  Globals
  Cavities::globals_at_rest() const
  {
    if (!any())
      return {};
    return {{cavity_pressure, std::vector<double>(walls.size(), 0.)}};
  }



  Border
  Cavities::border(const Vector   &solution,
                   const Globals  &globals,
                   const LoadTime &t,
                   Tangent        *tangent,
                   Vector         &r)
  {
    constexpr unsigned int     n_per_cell = CellUnknowns::n_per_cell;
    const std::vector<double> &P          = globals.at(cavity_pressure);
    const unsigned int         n          = walls.size();
    AssertDimension(P.size(), n);

    Vector u, a;
    unknowns.reinit_vector(u);
    unknowns.reinit_vector(a);
    u.copy_locally_owned_data_from(solution);
    u.update_ghost_values();

    Border              border;
    std::vector<double> sums(3 * n); // volumes, their rounding, what is missing
    double              of_cell[n_per_cell], forces[n_per_cell];
    double              missing[n_per_cell], change[n_per_cell];
    std::vector<double> matrix(n_per_cell * n_per_cell);
    ElementKernel       kernel;
    Vector              of_missing;
    unknowns.reinit_vector(of_missing);
    for (unsigned int k = 0; k < n; ++k)
      {
        a = 0.;
        for (const Face &face : walls[k].faces)
          {
            unknowns.read(face.cell, u, of_cell);
            kernel.set(of_cell);
            surface.reinit(face.iterator, face.number);
            std::fill(forces, forces + n_per_cell, 0.);
            if (tangent != nullptr)
              std::fill(matrix.begin(), matrix.end(), 0.);
            for (unsigned int q = 0; q < surface.n_points(); ++q)
              {
                surface.set(q, kernel.u);
                const auto   dA = area_out_of_cavity(surface);
                const double V  = volume_in_cavity(surface);
                sums[k] += V;
                sums[n + k] += std::abs(V);
                for (unsigned int c = 0; c < dim; ++c)
                  for (unsigned int m = 0; m < MixedSpace::n_nodes; ++m)
                    forces[CellUnknowns::displacement(c, m)] +=
                      surface.values[m] * dA[c];
                // -P da/du, where a points against N.
                if (tangent != nullptr)
                  add_area_derivative(surface, P[k], matrix);
              }
            unknowns.add(face.cell, forces, a);
            if (tangent == nullptr)
              continue;

            std::vector<double> &all = tangent->surface_matrix(face.cell);
            for (unsigned int i = 0; i < matrix.size(); ++i)
              all[i] += matrix[i];
            // What is prescribed and still missing pulls here too.
            if (unknowns.read_inhomogeneity(face.cell, missing))
              {
                for (unsigned int i = 0; i < n_per_cell; ++i)
                  {
                    change[i] = std::inner_product(missing,
                                                   missing + n_per_cell,
                                                   &matrix[i * n_per_cell],
                                                   0.);
                    sums[2 * n + k] += forces[i] * missing[i];
                  }
                unknowns.add(face.cell, change, of_missing);
              }
          }
        a.compress(dealii::VectorOperation::add);
        for (unsigned int i = 0; i < r.locally_owned_size(); ++i)
          r.local_element(i) -= P[k] * a.local_element(i);
        if (tangent != nullptr)
          {
            border.columns.emplace_back(a);
            border.columns.back().scale(-1.);
          }
      }
    if (tangent != nullptr)
      {
        of_missing.compress(dealii::VectorOperation::add);
        for (unsigned int i = 0; i < r.locally_owned_size(); ++i)
          r.local_element(i) += of_missing.local_element(i);
      }
    dealii::Utilities::MPI::sum(sums, body.space.communicator(), sums);

    border.names = {{cavity_pressure, n}};
    if (tangent != nullptr)
      border.corner.reinit(n, n);
    for (unsigned int k = 0; k < n; ++k)
      {
        const CavityEquation equation = content->equation(
          {walls[k].segment, sums[k], walls[k].volume_at_rest, P[k], t});
        border.residual.push_back(equation.s + equation.ds_dV * sums[2 * n + k]);
        border.scale.push_back(equation.scale * body_volume /
                               walls[k].volume_at_rest);
        border.rounding.push_back(std::numeric_limits<double>::epsilon() *
                                  std::abs(equation.ds_dV) * sums[n + k]);
        if (tangent == nullptr)
          continue;
        border.rows.push_back(border.columns[k]);
        border.rows.back().scale(-equation.ds_dV);
        border.corner(k, k) = equation.ds_dP;
      }
    return border;
  }
} // namespace lumbricus
