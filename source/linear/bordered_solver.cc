// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/linear/bordered_solver.h>

#include <deal.II/lac/exceptions.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>

namespace lumbricus
{
  namespace
  {
    constexpr unsigned int most_refinements = 6;

    // Of the rows of the border, relative to the terms that they add up.
    constexpr double border_tolerance = 1e-12;



    // S^(-1), which is small.
    class DenseInverse
    {
    public:
      explicit DenseInverse(const dealii::FullMatrix<double> &S)
        : scale(S.m())
        , factors(S.m())
      {
        // Rows are in different units.
        dealii::FullMatrix<double> scaled(S);
        for (unsigned int k = 0; k < S.m(); ++k)
          {
            double largest = 0.;
            for (unsigned int l = 0; l < S.n(); ++l)
              largest = std::max(largest, std::abs(S(k, l)));
            scale[k] = 1. / largest;
            for (unsigned int l = 0; l < S.n(); ++l)
              scaled(k, l) *= scale[k];
            check(std::isfinite(scale[k]));
          }
        factors = scaled;
        try
          {
            factors.compute_lu_factorization();
          }
        catch (const dealii::LACExceptions::ExcSingular &)
          {
            check(false);
          }
      }

      std::vector<double>
      operator()(const std::vector<double> &c) const
      {
        dealii::Vector<double> x(c.size());
        for (unsigned int k = 0; k < c.size(); ++k)
          x[k] = scale[k] * c[k];
        factors.solve(x);
        return {x.begin(), x.end()};
      }

    private:
      static void
      check(const bool is_regular)
      {
        AssertThrow(is_regular,
                    ExcNotConverged("The equations of the global unknowns "
                                    "do not determine them"));
      }

      std::vector<double>              scale;
      dealii::LAPACKFullMatrix<double> factors;
    };

  } // namespace



  BorderedSolver::BorderedSolver(LinearSolver  &linear_solver,
                                 const Tangent &tangent)
    : linear_solver(linear_solver)
    , tangent(tangent)
  {}



  void
  BorderedSolver::solve(Vector                &x,
                        std::vector<double>       &g,
                        const Vector          &b,
                        const std::vector<double> &c,
                        const Border              &border,
                        const double               tolerance)
  {
    const unsigned int                n = border.size();
    const dealii::FullMatrix<double> &D = border.corner;
    std::vector<Vector>           Z(n);
    dealii::FullMatrix<double>        S(D);
    for (unsigned int k = 0; k < n; ++k)
      {
        Z[k].reinit(b);
        linear_solver.solve(Z[k], border.columns[k], tolerance);
        for (unsigned int l = 0; l < n; ++l)
          S(l, k) -= border.rows[l] * Z[k];
      }
    const DenseInverse S_inverse(S);

    // What is left of the right-hand side, and how large it was.
    Vector          b_left(b), y(b);
    std::vector<double> c_left = c;
    const double        b_norm = b.l2_norm();
    x                          = 0.;
    g.assign(n, 0.);
    for (unsigned int refinement = 0; refinement <= most_refinements;
         ++refinement)
      {
        if (b_left.l2_norm() > 0.)
          linear_solver.solve(y, b_left, tolerance);
        else
          y = 0.;
        for (unsigned int k = 0; k < n; ++k)
          c_left[k] -= border.rows[k] * y;
        const std::vector<double> dg = S_inverse(c_left);
        x += y;
        for (unsigned int k = 0; k < n; ++k)
          {
            x.add(-dg[k], Z[k]);
            g[k] += dg[k];
          }

        tangent.vmult(b_left, x);
        b_left.sadd(-1., 1., b);
        double       b_level = b_norm;
        const double x_norm  = x.l2_norm();
        bool         done    = true;
        for (unsigned int k = 0; k < n; ++k)
          {
            b_left.add(-g[k], border.columns[k]);
            b_level = std::max(b_level,
                               std::abs(g[k]) * border.columns[k].l2_norm());
            double sum   = border.rows[k] * x;
            double level = border.rows[k].l2_norm() * x_norm + std::abs(c[k]);
            for (unsigned int l = 0; l < n; ++l)
              {
                sum += D(k, l) * g[l];
                level += std::abs(D(k, l) * g[l]);
              }
            c_left[k] = c[k] - sum;
            done      = done &&
                   std::abs(c_left[k]) <= border_tolerance * level;
          }
        if (done && b_left.l2_norm() <= tolerance * b_level)
          return;
      }
    AssertThrow(false,
                ExcNotConverged(
                  "The linear system with " + std::to_string(n) +
                  " global unknowns is not solved after " +
                  std::to_string(most_refinements) +
                  " refinements: without them the tangent is singular, or "
                  "nearly so"));
  }
} // namespace lumbricus
