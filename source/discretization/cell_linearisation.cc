// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/cell_linearisation.h>
#include <lumbricus/discretization/cell_sizes.h>
#include <lumbricus/materials/flowing_liquid.h>

#include <algorithm>
#include <cmath>

#include "dgemm.h"
#include "node_sums.h"

namespace lumbricus
{
  namespace
  {
    using cell_sizes::n_modes;
    using cell_sizes::n_nodes;
    constexpr unsigned int padded  = ShapeCache::padded_nodes;

    // Of the nine blocks of components i and k those with i <= k.
    constexpr unsigned int n_blocks = 6;

    constexpr unsigned int
    block(const unsigned int i, const unsigned int k)
    {
      return i == 0 ? k : i + k + 1; // 00 01 02 11 12 22 -> 0 ... 5
    }
  } // namespace



  void
  CellLinearisation::set(const unsigned int      q,
                         const MaterialResponse &response,
                         const double            JxW)
  {
    for (unsigned int a = 0; a < dim * dim; ++a)
      for (unsigned int b = a; b < dim * dim; ++b)
        A[pair(a, b)][q] = response.A[a][b] * JxW;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int J = 0; J < dim; ++J)
        Q[dim * i + J][q] = response.Q[i][J] * JxW;
    dc_dp[q]   = response.dc_dp * JxW;
    mu_missing = response.mu_missing;
  }



  void
  CellLinearisation::vmult(const ShapeCache::Cell &cell,
                           const double           *pressure_modes,
                           const double           *x,
                           double                 *y) const
  {
    alignas(64) double u[dim][padded] = {};
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int n = 0; n < n_nodes; ++n)
        u[c][n] = x[CellUnknowns::displacement(c, n)];

    // Grad du and dp at all points.
    alignas(64) double h[dim * dim][padded_q] = {};
    alignas(64) double p[padded_q]            = {};
    for (unsigned int q = 0; q < n_q; ++q)
      {
        gradient_at_point(cell,
                          q,
                          u,
                          [&](const unsigned int i,
                              const unsigned int J,
                              const double       value) {
                            h[dim * i + J][q] = value;
                          });
        for (unsigned int m = 0; m < n_modes; ++m)
          p[q] +=
            pressure_modes[n_modes * q + m] * x[CellUnknowns::pressure(m)];
      }

    // The stress and the change of volume that they cause.
    alignas(64) double s[dim * dim][padded_q] = {};
    alignas(64) double c[padded_q];
    for (unsigned int q = 0; q < padded_q; ++q)
      c[q] = dc_dp[q] * p[q];
    for (unsigned int a = 0; a < dim * dim; ++a)
      {
        for (unsigned int q = 0; q < padded_q; ++q)
          {
            s[a][q] += A[pair(a, a)][q] * h[a][q] + Q[a][q] * p[q];
            c[q] += Q[a][q] * h[a][q];
          }
        for (unsigned int b = a + 1; b < dim * dim; ++b)
          for (unsigned int q = 0; q < padded_q; ++q)
            {
              s[a][q] += A[pair(a, b)][q] * h[b][q];
              s[b][q] += A[pair(a, b)][q] * h[a][q];
            }
      }

    // Their virtual work.
    alignas(64) double force[dim][padded] = {};
    double             volume[n_modes]    = {};
    for (unsigned int q = 0; q < n_q; ++q)
      {
        for (unsigned int J = 0; J < dim; ++J)
          {
            const double *g   = cell.gradients + (dim * q + J) * padded;
            const double  s_0 = s[J][q], s_1 = s[dim + J][q],
                         s_2 = s[2 * dim + J][q];
            for (unsigned int n = 0; n < padded; ++n)
              {
                force[0][n] += s_0 * g[n];
                force[1][n] += s_1 * g[n];
                force[2][n] += s_2 * g[n];
              }
          }
        for (unsigned int m = 0; m < n_modes; ++m)
          volume[m] += pressure_modes[n_modes * q + m] * c[q];
      }

    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int n = 0; n < n_nodes; ++n)
        y[CellUnknowns::displacement(i, n)] = force[i][n];
    for (unsigned int m = 0; m < n_modes; ++m)
      y[CellUnknowns::pressure(m)] = volume[m];
  }



  void
  CellLinearisation::add_missing_stiffness(
    const unsigned int q,
    const double       JxW,
    double (&stiffness)[dim * dim][dim * dim]) const
  {
    dealii::Tensor<2, dim> Q_JxW;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int J = 0; J < dim; ++J)
        Q_JxW[i][J] = Q[dim * i + J][q];
    // det Q = J^2
    const double J = std::sqrt(determinant(Q_JxW) / (JxW * JxW * JxW));
    add_shear_stiffness(mu_missing / (J * JxW), Q_JxW, stiffness);
  }



  void
  CellLinearisation::diagonal(const ShapeCache::Cell &cell,
                              const double           *pressure_modes,
                              double                 *d) const
  {
    alignas(64) double of_nodes[dim][padded] = {};
    double             of_modes[n_modes]     = {};
    for (unsigned int q = 0; q < n_q; ++q)
      {
        const double *g0 = cell.gradients + dim * q * padded;
        const double *g1 = g0 + padded;
        const double *g2 = g1 + padded;

        double extra[dim * dim][dim * dim] = {};
        if (mu_missing > 0.)
          add_missing_stiffness(q, cell.JxW[q], extra);
        for (unsigned int i = 0; i < dim; ++i)
          {
            const auto a = [&](const unsigned int J, const unsigned int L) {
              const unsigned int iJ = dim * i + J, iL = dim * i + L;
              return A[pair(iJ, iL)][q] + extra[iJ][iL];
            };
            const double a00 = a(0, 0), a11 = a(1, 1), a22 = a(2, 2);
            const double a01 = 2. * a(0, 1), a02 = 2. * a(0, 2),
                         a12 = 2. * a(1, 2);
            for (unsigned int n = 0; n < padded; ++n)
              of_nodes[i][n] +=
                g0[n] * (a00 * g0[n] + a01 * g1[n] + a02 * g2[n]) +
                g1[n] * (a11 * g1[n] + a12 * g2[n]) + a22 * g2[n] * g2[n];
          }
        for (unsigned int m = 0; m < n_modes; ++m)
          {
            const double psi = pressure_modes[n_modes * q + m];
            of_modes[m] += dc_dp[q] * psi * psi;
          }
      }
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int n = 0; n < n_nodes; ++n)
        d[CellUnknowns::displacement(i, n)] = of_nodes[i][n];
    for (unsigned int m = 0; m < n_modes; ++m)
      d[CellUnknowns::pressure(m)] = of_modes[m];
  }



  void
  CellLinearisation::matrix(const ShapeCache::Cell &cell,
                            const double           *pressure_modes,
                            const bool              for_preconditioner,
                            std::vector<double>    &K) const
  {
    K.resize(n_unknowns * n_unknowns);
    alignas(64) static thread_local double H[n_q * dim][n_blocks * padded];
    alignas(64) static thread_local double K_uu[padded][n_blocks * padded];
    double                                 K_up[dim][n_nodes][n_modes] = {};
    double                                 K_pp[n_modes][n_modes]      = {};

    for (unsigned int q = 0; q < n_q; ++q)
      {
        const double *g0  = cell.gradients + dim * q * padded;
        const double *g1  = g0 + padded;
        const double *g2  = g1 + padded;
        const double *psi = pressure_modes + n_modes * q;

        double extra[dim * dim][dim * dim] = {};
        if (for_preconditioner && mu_missing > 0.)
          add_missing_stiffness(q, cell.JxW[q], extra);

        // H(i,k)[3 q + J][m] = A_iJkL dN_m/dX_L JxW
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int J = 0; J < dim; ++J)
            for (unsigned int k = i; k < dim; ++k)
              {
                double a[dim];
                for (unsigned int L = 0; L < dim; ++L)
                  {
                    const unsigned int iJ = dim * i + J, kL = dim * k + L;
                    a[L] = A[pair(std::min(iJ, kL), std::max(iJ, kL))][q] +
                           extra[iJ][kL];
                  }
                double *h = H[dim * q + J] + block(i, k) * padded;
                for (unsigned int m = 0; m < padded; ++m)
                  h[m] = a[0] * g0[m] + a[1] * g1[m] + a[2] * g2[m];
              }

        for (unsigned int i = 0; i < dim; ++i)
          {
            const double q0 = Q[dim * i][q], q1 = Q[dim * i + 1][q],
                         q2 = Q[dim * i + 2][q];
            for (unsigned int n = 0; n < n_nodes; ++n)
              {
                const double v = q0 * g0[n] + q1 * g1[n] + q2 * g2[n];
                for (unsigned int m = 0; m < n_modes; ++m)
                  K_up[i][n][m] += v * psi[m];
              }
          }
        for (unsigned int n = 0; n < n_modes; ++n)
          for (unsigned int m = 0; m < n_modes; ++m)
            K_pp[n][m] += dc_dp[q] * psi[n] * psi[m];
      }

    // K_uu = G^T H, with G the gradients; BLAS counts columns first.
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
           &K_uu[0][0],
           &m);

    const auto at = [&](const unsigned int r,
                        const unsigned int s) -> double & {
      return K[r * n_unknowns + s];
    };
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int k = i; k < dim; ++k)
        for (unsigned int n = 0; n < n_nodes; ++n)
          {
            const unsigned int r      = CellUnknowns::displacement(i, n);
            const double      *values = K_uu[n] + block(i, k) * padded;
            for (unsigned int m = 0; m < n_nodes; ++m)
              {
                const unsigned int s = CellUnknowns::displacement(k, m);
                at(r, s) = at(s, r) = values[m];
              }
          }
    for (unsigned int m = 0; m < n_modes; ++m)
      {
        const unsigned int s = CellUnknowns::pressure(m);
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int n = 0; n < n_nodes; ++n)
            {
              const unsigned int r = CellUnknowns::displacement(i, n);
              at(r, s) = at(s, r) = K_up[i][n][m];
            }
        for (unsigned int n = 0; n < n_modes; ++n)
          at(CellUnknowns::pressure(n), s) = K_pp[n][m];
      }
  }
} // namespace lumbricus
