// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_errors_finer_solver_h
#define lumbricus_errors_finer_solver_h

#include <lumbricus/errors/cut_cells.h>
#include <lumbricus/errors/enrichment.h>
#include <lumbricus/linear/linear_solver.h>

#include <functional>
#include <memory>

namespace lumbricus
{
  /**
   * Solves linear systems of small cells, eight in place of each of a mesh that has
   * a solver of its own, as far as an estimate of errors needs it: some iterations
   * of FGMRES with a correction by the Enrichment, and then by the large cells,
   *
   *   y = E A^(-1) E^T r,   x = y + P K^(-1) P^T (r - K y).
   *
   * Residuals are measured with forces and volumes in proportion to the
   * diagonal, r_u / sqrt(K_ii) and r_p / sqrt(mu / M_ii).
   */
  class FinerSolver : public LinearSolver
  {
  public:
    /** How to solve with the tangent of the large cells and the border there,
     * (x, g, b, c): as LinearSolver::solve(). */
    using OnLargeCells = std::function<void(Vector                    &,
                                            std::vector<double>       &,
                                            const Vector              &,
                                            const std::vector<double> &)>;

    /** With so many iterations. */
    FinerSolver(const OnLargeCells &on_large_cells,
                const unsigned int  n_iterations);

    /** For the cells @p small, whose tangent reinit() has got; both arguments are
     * kept by reference. Before solve(). Collective. */
    void
    set_cells(const Body &small, const CutCells &new_cells);

    /**
     * Where the error of a number comes from: of each owned large cell
     * |sum_i b_i y_i| over what is inside of it,
     *
     *   y = E A^(-1) E^T (j - K^T P z),   K_large^T z = P^T j,
     *
     * with the right-hand side @p b of solve(), after that, and the derivatives
     * @p j and @p of_globals of the number. The functions of large cells do not
     * matter, on which b is zero. The tangent itself takes the place of K^T, of
     * @p border what it is transposed. @p dual_on_large_cells solves with both there.
     * Collective.
     */
    std::vector<double>
    contributions(const Vector              &b,
                  const Vector              &j,
                  const std::vector<double> &of_globals,
                  const Border              &border,
                  const OnLargeCells        &dual_on_large_cells) const;

    void
    reinit(const Tangent &new_tangent) override;

    using LinearSolver::solve;

    /** Throws ExcNotConverged where @p b is not finite. */
    void
    solve(Vector &x, const Vector &b, const double tolerance) override;

  protected:
    void
    solve_bordered(Vector                    &x,
                   std::vector<double>       &g,
                   const Vector              &b,
                   const std::vector<double> &c,
                   const Border              &border,
                   const double               tolerance) override;

  private:
    /** What residuals of the free unknowns are multiplied with. Collective. */
    Vector
    scale() const;

    const OnLargeCells          on_large_cells;
    const unsigned int          n_iterations;
    const CutCells             *cells   = nullptr;
    const Tangent              *tangent = nullptr;
    std::unique_ptr<Enrichment> enrichment;
  };
} // namespace lumbricus

#endif
