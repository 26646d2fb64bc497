// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/element_kernel.h>

#include <algorithm>
#include <cstring>
#include <limits>

extern "C" void
dgemm_(const char   *transa,
       const char   *transb,
       const int    *m,
       const int    *n,
       const int    *k,
       const double *alpha,
       const double *a,
       const int    *lda,
       const double *b,
       const int    *ldb,
       const double *beta,
       double       *c,
       const int    *ldc);

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



  double
  ElementKernel::compute_deformation(const ShapeCache::Cell &cell)
  {
    double min_J = std::numeric_limits<double>::max();
    for (unsigned int q = 0; q < n_q; ++q)
      {
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int J = 0; J < dim; ++J)
            {
              const double *gradient = cell.gradients + (dim * q + J) * padded;
              double        sum      = 0.;
              for (unsigned int n = 0; n < padded; ++n)
                sum += u[i][n] * gradient[n];
              F[q][i][J] = sum + (i == J ? 1. : 0.);
            }
        min_J = std::min(min_J, dealii::determinant(F[q]));
      }
    return min_J;
  }



  double
  ElementKernel::displacement(const double      *node_values,
                              const unsigned int q,
                              const unsigned int c) const
  {
    double value = 0.;
    for (unsigned int n = 0; n < n_nodes; ++n)
      value += u[c][n] * node_values[n_nodes * q + n];
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
                          const MaterialLaw      &law,
                          const ReferencePoint   *references,
                          const bool              with_tangent)
  {
    const double min_J = compute_deformation(cell);
    if (!(min_J > 0.))
      return min_J;

    std::memset(force, 0, sizeof(force));
    std::memset(volume, 0, sizeof(volume));
    if (with_tangent)
      {
        std::memset(K_up, 0, sizeof(K_up));
        std::memset(K_pp, 0, sizeof(K_pp));
      }

    MaterialResponse response;
    for (unsigned int q = 0; q < n_q; ++q)
      {
        law.evaluate(F[q],
                     pressure(pressure_modes, q),
                     references[q],
                     with_tangent,
                     response);
        add_residual(cell, pressure_modes, q, response);
        if (with_tangent)
          add_tangent(cell, pressure_modes, q, response);
      }

    if (with_tangent)
      {
        // K_blocks = G^T H, with G the gradients; BLAS counts columns first.
        const int    m = n_blocks * padded, n = padded, k = n_q * dim;
        const double one = 1., zero = 0.;
        dgemm_("N",
               "T",
               &m,
               &n,
               &k,
               &one,
               &H[0][0],
               &m,
               cell.gradients,
               &n,
               &zero,
               &K_blocks[0][0],
               &m);
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



  void
  ElementKernel::add_tangent(const ShapeCache::Cell &cell,
                             const double           *pressure_modes,
                             const unsigned int      q,
                             const MaterialResponse &response)
  {
    const double  w   = cell.JxW[q];
    const double *g0  = cell.gradients + dim * q * padded;
    const double *g1  = g0 + padded;
    const double *g2  = g1 + padded;
    const double *psi = pressure_modes + n_modes * q;

    // H(i,k)[3 q + J][m] = w A_iJkL dN_m/dX_L
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int J = 0; J < dim; ++J)
        for (unsigned int k = i; k < dim; ++k)
          {
            const double *A  = response.A[dim * i + J] + dim * k;
            const double  a0 = w * A[0], a1 = w * A[1], a2 = w * A[2];
            double       *h = H[dim * q + J] + block(i, k) * padded;
            for (unsigned int m = 0; m < padded; ++m)
              h[m] = a0 * g0[m] + a1 * g1[m] + a2 * g2[m];
          }

    for (unsigned int i = 0; i < dim; ++i)
      {
        const double q0 = w * response.Q[i][0], q1 = w * response.Q[i][1],
                     q2 = w * response.Q[i][2];
        for (unsigned int n = 0; n < n_nodes; ++n)
          {
            const double v = q0 * g0[n] + q1 * g1[n] + q2 * g2[n];
            for (unsigned int m = 0; m < n_modes; ++m)
              K_up[i][n][m] += v * psi[m];
          }
      }

    for (unsigned int n = 0; n < n_modes; ++n)
      for (unsigned int m = 0; m < n_modes; ++m)
        K_pp[n][m] += w * response.dc_dp * psi[n] * psi[m];
  }
} // namespace lumbricus
