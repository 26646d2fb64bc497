// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_linear_solver_h
#define lumbricus_linear_linear_solver_h

#include <lumbricus/discretization/border.h>
#include <lumbricus/discretization/tangent.h>
#include <lumbricus/parameters/parameter_owner.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace lumbricus
{
  /** What a linear solver did since it was made, for tables and logs. */
  struct LinearSolverStatistics
  {
    unsigned int n_solves         = 0;  ///< that succeeded
    unsigned int n_iterations     = 0;  ///< of all tries
    unsigned int most_iterations  = 0;  ///< of one try
    unsigned int n_factorisations = 0;  ///< or cycles of multigrid set up
    double       factor_seconds   = 0.; ///< for these
    double       solve_seconds    = 0.; ///< for the rest
  };



  /**
   * Solves K x = b for the tangent of the mixed problem (indefinite; symmetric
   * where the loads are). All functions are collective.
   */
  class LinearSolver : public ParameterOwner
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler & /*prm*/) override
    {}

    /** Called when the mesh or the constraints are new: forget the old.
     * @p tangent must live as long as it is used. */
    virtual void
    reinit(const Tangent &tangent) = 0;

    /**
     * Solve with what the tangent is now, to the relative residual
     * @p tolerance or better; x is zero in the constrained unknowns. Both
     * vectors are made by CellUnknowns::reinit_vector(). Throws ExcNotConverged
     * where that is not possible.
     */
    virtual void
    solve(Vector &x, const Vector &b, const double tolerance) = 0;

    /**
     * The same with @p border around the tangent, for the right-hand sides b
     * and c, to a residual of all rows together that is small beside these or
     * beside a term of B g. Throws ExcNotConverged also where the border does
     * not determine its unknowns. With a border that has none it is the tangent
     * alone, and @p g is empty.
     */
    void
    solve(Vector                    &x,
          std::vector<double>       &g,
          const Vector              &b,
          const std::vector<double> &c,
          const Border              &border,
          const double               tolerance)
    {
      if (border.size() > 0)
        {
          solve_bordered(x, g, b, c, border, tolerance);
          return;
        }
      solve(x, b, tolerance);
      g.clear();
    }

    /** What the solver did since it was made. */
    const LinearSolverStatistics &
    statistics() const
    {
      return counts;
    }

    /** Call @p listener with what the user should know, as it happens. */
    void
    report_to(const std::function<void(const std::string &)> &new_listener)
    {
      listener = new_listener;
    }

  protected:
    /** Solve with a border that has unknowns. */
    virtual void
    solve_bordered(Vector                    &x,
                   std::vector<double>       &g,
                   const Vector              &b,
                   const std::vector<double> &c,
                   const Border              &border,
                   const double               tolerance) = 0;

    /** Let the user know @p message. */
    void
    tell(const std::string &message)
    {
      if (listener)
        listener(message);
    }

    /** Count those of one try to solve. */
    void
    count_iterations(const unsigned int n)
    {
      counts.n_iterations += n;
      counts.most_iterations = std::max(counts.most_iterations, n);
    }

    /** For derived classes to count in. */
    LinearSolverStatistics counts;

  private:
    std::function<void(const std::string &)> listener;
  };
} // namespace lumbricus

#endif
