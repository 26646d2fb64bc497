// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/cell_unknowns.h>

#include <algorithm>

#include "cell_laplacian.h"

namespace lumbricus
{
  CellLaplacian::CellLaplacian(const ShapeCache::Cell &cell)
  {
    for (unsigned int q = 0; q < MixedSpace::n_q_points; ++q)
      for (unsigned int J = 0; J < dim; ++J)
        {
          const double *g = cell.gradients + (dim * q + J) * padded;
          for (unsigned int m = 0; m < n_nodes; ++m)
            {
              const double g_m = g[m] * cell.JxW[q];
              for (unsigned int n = 0; n < padded; ++n)
                K[m][n] += g_m * g[n];
            }
        }
  }



  void
  CellLaplacian::vmult(const double *x, double *y) const
  {
    // K is symmetric: its rows are its columns.
    alignas(64) double y_of[dim][padded] = {};
    for (unsigned int m = 0; m < n_nodes; ++m)
      for (unsigned int c = 0; c < dim; ++c)
        {
          const double x_m = x[CellUnknowns::displacement(c, m)];
          for (unsigned int n = 0; n < padded; ++n)
            y_of[c][n] += x_m * K[m][n];
        }
    std::fill(y, y + CellUnknowns::n_per_cell, 0.);
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int n = 0; n < n_nodes; ++n)
        y[CellUnknowns::displacement(c, n)] = y_of[c][n];
  }
} // namespace lumbricus
