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
    constexpr unsigned int n_per_cell = CellUnknowns::n_per_cell;

    // The area hangs on the nodes of the face only.
    const auto             cofactor = dealii::cofactor(surface.F);
    const auto             a        = cofactor * surface.N;
    const double           J        = dealii::determinant(surface.F);
    dealii::Tensor<1, dim> spatial[SurfaceKernel::n_nodes]; // F^(-T) Grad N
    for (const unsigned int n : surface.face_nodes)
      spatial[n] = cofactor * surface.gradients[n] / J;
    const double half = 0.5 * factor * surface.JxW;
    for (const unsigned int n : surface.face_nodes)
      for (const unsigned int m : surface.face_nodes)
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int k = 0; k < dim; ++k)
            {
              const double       value = half * surface.values[n] *
                                   (a[c] * spatial[m][k] - a[k] * spatial[m][c]);
              const unsigned int row    = CellUnknowns::displacement(c, n);
              const unsigned int column = CellUnknowns::displacement(k, m);
              matrix[row * n_per_cell + column] += value;
              matrix[column * n_per_cell + row] += value;
            }
  }
} // namespace lumbricus
