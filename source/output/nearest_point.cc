// SPDX-License-Identifier: LGPL-2.1-or-later

#include "nearest_point.h"

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature.h>
#include <deal.II/base/tensor.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/grid/cell_id.h>
#include <deal.II/grid/filtered_iterator.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <vector>

namespace lumbricus
{
  namespace
  {
    using dealii::Point;
    using dealii::Tensor;
    using Cell = dealii::Triangulation<dim>::active_cell_iterator;

    // A point of a cell, by its place in the unit cell.
    struct Candidate
    {
      Cell       cell;
      Point<dim> unit_point;
      double     distance;
    };



    // The point of a cell nearest to @p point: Gauss-Newton for the distance,
    // within the unit cell.
    Candidate
    nearest_in_cell(const Point<dim>           &point,
                    const Cell                 &cell,
                    const dealii::Mapping<dim> &mapping)
    {
      const dealii::FE_Nothing<dim> fe;
      Candidate nearest = {cell, {}, std::numeric_limits<double>::max()};
      Point<dim> xi(0.5, 0.5, 0.5), last = xi;
      for (unsigned int i = 0; i < 60; ++i)
        {
          dealii::FEValues<dim> values(mapping,
                                       fe,
                                       dealii::Quadrature<dim>(xi),
                                       dealii::update_quadrature_points |
                                         dealii::update_jacobians);
          values.reinit(cell);
          const Tensor<1, dim> off = point - values.quadrature_point(0);
          if (off.norm() >= nearest.distance)
            {
              // Too long a step.
              if (xi.distance(last) < 1e-10)
                break;
              xi = last + 0.5 * (xi - last);
              continue;
            }
          nearest.unit_point = last = xi;
          nearest.distance          = off.norm();

          const Tensor<2, dim> J(values.jacobian(0));
          Tensor<1, dim>       downhill = transpose(J) * off;
          Tensor<2, dim>       matrix   = transpose(J) * J;
          for (unsigned int d = 0; d < dim; ++d)
            if ((xi[d] <= 0. && downhill[d] < 0.) ||
                (xi[d] >= 1. && downhill[d] > 0.))
              {
                downhill[d] = 0.;
                for (unsigned int e = 0; e < dim; ++e)
                  matrix[d][e] = matrix[e][d] = d == e;
              }
          if (determinant(matrix) == 0.)
            break;
          xi += dealii::invert(matrix) * downhill;
          for (unsigned int d = 0; d < dim; ++d)
            xi[d] = std::min(1., std::max(0., xi[d]));
          if (xi.distance(last) < 1e-12)
            break;
        }
      return nearest;
    }



    // The candidates among this rank's cells that have @p point.
    std::vector<Candidate>
    cells_with(const Point<dim>                 &point,
               const dealii::Triangulation<dim> &triangulation,
               const dealii::Mapping<dim>       &mapping)
    {
      std::vector<Candidate> found;
      for (const auto &cell : triangulation.active_cell_iterators() |
                                dealii::IteratorFilters::LocallyOwnedCell())
        {
          if (cell->center().distance(point) > cell->diameter())
            continue;
          try
            {
              const auto unit =
                mapping.transform_real_to_unit_cell(cell, point);
              if (dealii::GeometryInfo<dim>::distance_to_unit_cell(unit) < 1e-6)
                found.push_back({cell, unit, 0.});
            }
          catch (const dealii::Mapping<dim>::ExcTransformationFailed &)
            {
              // So far outside that the map cannot be inverted there.
            }
        }
      return found;
    }



    // The nearest points of those of this rank's cells that may have the
    // nearest of all.
    std::vector<Candidate>
    nearest_of_cells(const Point<dim>                 &point,
                     const dealii::Triangulation<dim> &triangulation,
                     const dealii::Mapping<dim>       &mapping)
    {
      const auto owned = triangulation.active_cell_iterators() |
                         dealii::IteratorFilters::LocallyOwnedCell();
      double at_most = std::numeric_limits<double>::max();
      for (const auto &cell : owned)
        at_most = std::min(at_most, cell->center().distance(point));
      at_most =
        dealii::Utilities::MPI::min(at_most, triangulation.get_communicator());

      std::vector<Candidate> found;
      for (const auto &cell : owned)
        if (cell->center().distance(point) - 0.75 * cell->diameter() <= at_most)
          found.push_back(nearest_in_cell(point, cell, mapping));
      return found;
    }



    double
    longest_edge(const Cell &cell)
    {
      double longest = 0.;
      for (const unsigned int line : cell->line_indices())
        longest = std::max(longest, cell->line(line)->diameter());
      return longest;
    }
  } // namespace



  NearestPoint
  nearest_point(const dealii::Point<dim>         &point,
                const dealii::Triangulation<dim> &triangulation,
                const dealii::Mapping<dim>       &mapping)
  {
    const MPI_Comm comm = triangulation.get_communicator();

    auto candidates = cells_with(point, triangulation, mapping);
    if (dealii::Utilities::MPI::sum<unsigned int>(candidates.size(), comm) == 0)
      candidates = nearest_of_cells(point, triangulation, mapping);

    double least = std::numeric_limits<double>::max();
    for (const Candidate &candidate : candidates)
      least = std::min(least, candidate.distance);
    least = dealii::Utilities::MPI::min(least, comm);

    // Neighbours that share the nearest point find it up to rounding.
    const Candidate *best = nullptr;
    for (const Candidate &candidate : candidates)
      if (candidate.distance <=
            least + 1e-6 * candidate.cell->diameter() * (least > 0.) &&
          (best == nullptr || candidate.cell->id() < best->cell->id()))
        best = &candidate;
    const auto ids = dealii::Utilities::MPI::all_gather(
      comm, best == nullptr ? std::string() : best->cell->id().to_string());
    unsigned int owner = ids.size();
    for (unsigned int rank = 0; rank < ids.size(); ++rank)
      if (!ids[rank].empty() &&
          (owner == ids.size() ||
           dealii::CellId(ids[rank]) < dealii::CellId(ids[owner])))
        owner = rank;

    NearestPoint nearest;
    nearest.mine = owner == dealii::Utilities::MPI::this_mpi_process(comm);
    std::array<double, dim + 2> known = {};
    if (nearest.mine)
      {
        nearest.cell       = best->cell;
        nearest.unit_point = best->unit_point;
        const auto position =
          mapping.transform_unit_to_real_cell(best->cell, best->unit_point);
        known = {{position[0],
                  position[1],
                  position[2],
                  best->distance,
                  longest_edge(best->cell)}};
      }
    known = dealii::Utilities::MPI::broadcast(comm, known, owner);
    for (unsigned int d = 0; d < dim; ++d)
      nearest.position[d] = known[d];
    nearest.distance  = known[dim];
    nearest.cell_size = known[dim + 1];
    return nearest;
  }
} // namespace lumbricus
