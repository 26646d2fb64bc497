// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/element_kernel.h>
#include <lumbricus/discretization/same_cell.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "node_sums.h"

namespace lumbricus
{
  void
  ElementKernel::read(const MixedSpace &space,
                      const dealii::DoFHandler<dim>::active_cell_iterator &cell,
                      const Vector &relevant_solution,
                      std::vector<dealii::types::global_dof_index> &indices)
  {
    cell->get_dof_indices(indices);
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int n = 0; n < n_nodes; ++n)
        u[c][n] = relevant_solution(indices[space.displacement_dof[c][n]]);
    for (unsigned int m = 0; m < n_modes; ++m)
      p[m] = relevant_solution(indices[space.pressure_dof[m]]);
  }



  void
  ElementKernel::read_history(
    const MixedSpace                                    &space,
    const dealii::DoFHandler<dim>::active_cell_iterator &cell,
    const Vector                                        &history,
    std::vector<dealii::types::global_dof_index>        &indices)
  {
    same_cell(cell, space.rest_dof_handler)->get_dof_indices(indices);
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int n = 0; n < n_nodes; ++n)
        u[c][n] = history[indices[space.rest_dof[c][n]]];
  }



  void
  ElementKernel::set(const double *values)
  {
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int n = 0; n < n_nodes; ++n)
        u[c][n] = values[CellUnknowns::displacement(c, n)];
    for (unsigned int m = 0; m < n_modes; ++m)
      p[m] = values[CellUnknowns::pressure(m)];
  }



  void
  ElementKernel::get_residual(double *values) const
  {
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int n = 0; n < n_nodes; ++n)
        values[CellUnknowns::displacement(c, n)] = force[c][n];
    for (unsigned int m = 0; m < n_modes; ++m)
      values[CellUnknowns::pressure(m)] = volume[m];
  }



  double
  ElementKernel::compute_deformation(const ShapeCache::Cell &cell)
  {
    // Relative to the last node: a translation adds nothing to F, but its
    // rounding would add to the sums.
    alignas(64) double relative[dim][padded] = {};
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int n = 0; n < n_nodes; ++n)
        relative[c][n] = u[c][n] - u[c][n_nodes - 1];

    double min_J = std::numeric_limits<double>::max();
    for (unsigned int q = 0; q < n_q; ++q)
      {
        gradient_at_point(cell,
                          q,
                          relative,
                          [&](const unsigned int i,
                              const unsigned int J,
                              const double       value) {
                            F[q][i][J] = value + (i == J ? 1. : 0.);
                          });
        min_J = std::min(min_J, dealii::determinant(F[q]));
      }
    return min_J;
  }



  dealii::Tensor<1, dim>
  ElementKernel::displacement(const double *N) const
  {
    dealii::Tensor<1, dim> value;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int n = 0; n < n_nodes; ++n)
        value[c] += u[c][n] * N[n];
    return value;
  }



  double
  ElementKernel::pressure(const double      *pressure_modes,
                          const unsigned int q) const
  {
    double value = 0.;
    for (unsigned int m = 0; m < n_modes; ++m)
      value += p[m] * pressure_modes[n_modes * q + m];
    return value;
  }



  double
  ElementKernel::evaluate(const ShapeCache::Cell &cell,
                          const double           *pressure_modes,
                          const Tissue           &tissue,
                          const MaterialPoint    *points,
                          CellLinearisation      *linearisation)
  {
    const double min_J = compute_deformation(cell);
    if (!(min_J > 0.))
      return min_J;

    std::memset(force, 0, sizeof(force));
    std::memset(volume, 0, sizeof(volume));
    MaterialResponse response;
    for (unsigned int q = 0; q < n_q; ++q)
      {
        tissue.evaluate(F[q],
                        pressure(pressure_modes, q),
                        points[q],
                        linearisation != nullptr,
                        response);
        add_residual(cell, pressure_modes, q, response);
        if (linearisation != nullptr)
          linearisation->set(q, response, cell.JxW[q]);
      }
    return min_J;
  }



  void
  ElementKernel::add_residual(const ShapeCache::Cell &cell,
                              const double           *pressure_modes,
                              const unsigned int      q,
                              const MaterialResponse &response)
  {
    for (unsigned int J = 0; J < dim; ++J)
      {
        const double *gradient = cell.gradients + (dim * q + J) * padded;
        for (unsigned int i = 0; i < dim; ++i)
          {
            const double P_w = response.P[i][J] * cell.JxW[q];
            for (unsigned int n = 0; n < padded; ++n)
              force[i][n] += P_w * gradient[n];
          }
      }
    for (unsigned int m = 0; m < n_modes; ++m)
      volume[m] += pressure_modes[n_modes * q + m] * response.c * cell.JxW[q];
  }
} // namespace lumbricus
