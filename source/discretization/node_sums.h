// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_node_sums_h
#define lumbricus_discretization_node_sums_h

#include <lumbricus/discretization/shape_cache.h>

namespace lumbricus
{
  /**
   * Call function(i, J, sum_n u[i][n] dN_n/dX_J) at quadrature point @p q: the
   * gradient of a displacement with values u at the padded nodes. The sums may
   * be added up in any order (-fopenmp-simd).
   */
  template <typename Function>
  inline void
  gradient_at_point(const ShapeCache::Cell &cell,
                    const unsigned int      q,
                    const double (&u)[dim][ShapeCache::padded_nodes],
                    const Function &function)
  {
    for (unsigned int J = 0; J < dim; ++J)
      {
        const double *g =
          cell.gradients + (dim * q + J) * ShapeCache::padded_nodes;
        double sum_0 = 0., sum_1 = 0., sum_2 = 0.;
#pragma omp simd reduction(+ : sum_0, sum_1, sum_2)
        for (unsigned int n = 0; n < ShapeCache::padded_nodes; ++n)
          {
            sum_0 += u[0][n] * g[n];
            sum_1 += u[1][n] * g[n];
            sum_2 += u[2][n] * g[n];
          }
        function(0, J, sum_0);
        function(1, J, sum_1);
        function(2, J, sum_2);
      }
  }
} // namespace lumbricus

#endif
