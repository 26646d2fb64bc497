// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_bordered_solver_h
#define lumbricus_linear_bordered_solver_h

#include <lumbricus/discretization/border.h>
#include <lumbricus/linear/linear_solver.h>

#include <vector>

namespace lumbricus
{
  /**
   * Solves a linear system with a Border around the tangent K,
   *
   *   [ K  B ] [x]   [b]
   *   [ C  D ] [g] = [c],
   *
   * by any LinearSolver for K, which keeps its factors:
   *
   *   Z = K^(-1) B,  S = D - C Z,  y = K^(-1) b,
   *   g = S^(-1) (c - C y),  x = y - Z g,
   *
   * with the small S dense and the same on all ranks, and the same again for
   * what is left of the right-hand side, until next to nothing is. That also
   * makes up for a K that is nearly singular, as close to a limit point, while
   * the whole is not. Where K is singular to rounding there is no solution this
   * way, and ExcNotConverged says so.
   */
  class BorderedSolver
  {
  public:
    /** Both arguments are kept by reference; the solver has been given the
     * tangent. */
    BorderedSolver(LinearSolver &linear_solver, const Tangent &tangent);

    /**
     * Solve, to a residual of @p tolerance times b or a term of B g in the rows
     * of K, and next to none in the others. What @p x and @p g are at first
     * makes no difference. Throws ExcNotConverged. Collective.
     */
    void
    solve(Vector                &x,
          std::vector<double>       &g,
          const Vector          &b,
          const std::vector<double> &c,
          const Border              &border,
          const double               tolerance);

  private:
    LinearSolver  &linear_solver;
    const Tangent &tangent;
  };
} // namespace lumbricus

#endif
