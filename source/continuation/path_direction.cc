// SPDX-License-Identifier: LGPL-2.1-or-later
#include "path_direction.h"

#include <lumbricus/discretization/shape_cache.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace lumbricus
{
  PathMetric::PathMetric(const Body         &body,
                         const CellUnknowns &unknowns,
                         const double        displacement)
    : body(body)
    , unknowns(unknowns)
  {
    double volume = 0.;
    for (const OwnedCell cell : body.owned_cells())
      if (!cell.is_liquid)
        for (unsigned int q = 0; q < MixedSpace::n_q_points; ++q)
          volume += body.shapes.cell(cell.index).JxW[q];
    volume = dealii::Utilities::MPI::sum(volume, body.space.communicator());
    factor = 0.5 * displacement * displacement / volume;
  }



  Vector
  PathMetric::row(const Vector &u) const
  {
    const Vector        relevant = body.space.with_ghosts(u);
    Vector              sum;
    std::vector<double> of_cell(CellUnknowns::n_per_cell);
    std::vector<dealii::types::global_dof_index> indices(
      body.space.fe.n_dofs_per_cell());
    unknowns.reinit_vector(sum);
    for (const OwnedCell cell : body.owned_cells())
      {
        if (cell.is_liquid)
          continue;
        cell.iterator->get_dof_indices(indices);
        std::fill(of_cell.begin(), of_cell.end(), 0.);
        const double *JxW = body.shapes.cell(cell.index).JxW;
        for (unsigned int q = 0; q < MixedSpace::n_q_points; ++q)
          {
            const double *N = body.shapes.node_values(q);
            for (unsigned int c = 0; c < dim; ++c)
              {
                double value = 0.;
                for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
                  value +=
                    N[n] * relevant(indices[body.space.displacement_dof[c][n]]);
                for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
                  of_cell[CellUnknowns::displacement(c, n)] +=
                    factor * value * N[n] * JxW[q];
              }
          }
        unknowns.add(cell.index, of_cell.data(), sum);
      }
    sum.compress(dealii::VectorOperation::add);
    return sum;
  }



  double
  PathMetric::product(const Vector        &row,
                      const double         t,
                      const PathDirection &way) const
  {
    double sum = 0.;
    for (unsigned int i = 0; i < row.locally_owned_size(); ++i)
      sum += row.local_element(i) * way.u.local_element(i);
    return dealii::Utilities::MPI::sum(sum, body.space.communicator()) +
           0.5 * t * way.t;
  }



  double
  PathMetric::length(const PathDirection &way) const
  {
    return std::sqrt(product(row(way.u), way.t, way));
  }



  double
  PathMetric::mean_displacement(const Body         &body,
                                const CellUnknowns &unknowns,
                                const Vector       &u)
  {
    const PathMetric metric(body, unknowns, std::sqrt(2.));
    return metric.length({u, 0.});
  }
} // namespace lumbricus
