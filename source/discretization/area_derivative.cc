// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/area_derivative.h>

#include <deal.II/base/tensor.h>

namespace lumbricus
{
  void
  add_area_derivative(const SurfaceKernel &surface,
                      const double         factor,
                      std::vector<double> &matrix)
  {
    constexpr unsigned int n_nodes    = SurfaceKernel::n_nodes;
    constexpr unsigned int n_per_cell = CellUnknowns::n_per_cell;

    const auto             cofactor = dealii::cofactor(surface.F);
    const auto             a        = cofactor * surface.N;
    const double           J        = dealii::determinant(surface.F);
    dealii::Tensor<1, dim> spatial[n_nodes]; // F^(-T) Grad N
    for (unsigned int n = 0; n < n_nodes; ++n)
      spatial[n] = cofactor * surface.gradients[n] / J;
    const double half = 0.5 * factor * surface.JxW;
    for (unsigned int n = 0; n < n_nodes; ++n)
      {
        const double N_n = surface.values[n];
        if (N_n == 0.)
          continue;
        for (unsigned int m = 0; m < n_nodes; ++m)
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int k = 0; k < dim; ++k)
              {
                const double value =
                  half * N_n * (a[c] * spatial[m][k] - a[k] * spatial[m][c]);
                const unsigned int row    = CellUnknowns::displacement(c, n);
                const unsigned int column = CellUnknowns::displacement(k, m);
                matrix[row * n_per_cell + column] += value;
                matrix[column * n_per_cell + row] += value;
              }
      }
  }
} // namespace lumbricus
