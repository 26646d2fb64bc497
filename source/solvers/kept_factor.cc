// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/registry.h>
#include <lumbricus/solvers/condensed_factor.h>
#include <lumbricus/solvers/linear_solver.h>

#include <deal.II/base/timer.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>

#include <algorithm>
#include <cmath>

namespace lumbricus
{
  /**
   * FGMRES, preconditioned by a factorisation of an earlier tangent, which is
   * kept across Newton iterations, resets and load steps for as long as the
   * iterations it costs are fewer than a new one is worth.
   */
  class KeptFactor : public LinearSolver
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("Most iterations",
                        most_iterations,
                        "[-] With more iterations than these the matrix is "
                        "factored again at once.",
                        dealii::Patterns::Integer(1));
    }

    void
    reinit(const Tangent &new_tangent) override
    {
      tangent  = &new_tangent;
      pivoting = false;
      factors.reset();
    }

    void
    solve(CellVector &x, const CellVector &b, const double tolerance) override
    {
      const bool fresh = factors == nullptr || age.worn_out(factors->cost());
      if (fresh)
        factor();
      bool converged = iterate(x, b, tolerance);
      if (!converged && !fresh)
        {
          factor();
          converged = iterate(x, b, tolerance);
        }
      if (!converged && !pivoting)
        {
          factor_with_pivoting();
          converged = iterate(x, b, tolerance);
        }
      AssertThrow(converged,
                  ExcNotConverged("The linear solver does not reach its "
                                  "tolerance in " +
                                  std::to_string(most_iterations) +
                                  " iterations, even with new factors"));
      ++counts.n_solves;
    }

  private:
    /**
     * When to factor again: as soon as the last solve cost more iterations
     * beyond what new factors would need than the average of all since the
     * last factorisation, its own cost included. That is where the average
     * has its minimum.
     */
    struct Age
    {
      unsigned int n_solves   = 0;
      double       per_decade = 0.;
      double       excess     = 0.;
      double       all_excess = 0.;

      void
      solved(const unsigned int n_iterations, const double tolerance)
      {
        const double decades = std::max(1., -std::log10(tolerance));
        if (n_solves++ == 0)
          per_decade = n_iterations / decades;
        excess = std::max(0., n_iterations - per_decade * decades);
        all_excess += excess;
      }

      bool
      worn_out(const double cost_of_factors) const
      {
        return n_solves > 0 && excess * n_solves > cost_of_factors + all_excess;
      }
    };

    void
    factor()
    {
      dealii::Timer timer;
      if (factors == nullptr)
        factors =
          std::make_unique<CondensedFactor>(*tangent,
                                            pivoting,
                                            tangent->space.communicator());
      age = Age();
      ++counts.n_factorisations;
      try
        {
          factors->factor();
        }
      catch (const ExcNotConverged &)
        {
          if (pivoting)
            throw;
          factor_with_pivoting();
          return;
        }
      counts.factor_seconds += timer.wall_time();
    }

    /** From now on, until the mesh or the constraints are new. */
    void
    factor_with_pivoting()
    {
      pivoting = true;
      factors.reset();
      factor();
    }

    /** @return whether FGMRES converged. */
    bool
    iterate(CellVector &x, const CellVector &b, const double tolerance)
    {
      dealii::Timer         timer;
      dealii::SolverControl control(most_iterations, tolerance * b.l2_norm());
      dealii::SolverFGMRES<CellVector> solver(
        control,
        dealii::SolverFGMRES<CellVector>::AdditionalData(most_iterations));
      bool converged = true;
      x              = 0.;
      try
        {
          solver.solve(*tangent, x, b, *factors);
        }
      catch (const dealii::SolverControl::NoConvergence &)
        {
          converged = false;
        }
      age.solved(control.last_step(), tolerance);
      counts.n_iterations += control.last_step();
      counts.solve_seconds += timer.wall_time();
      return converged;
    }

    unsigned int                     most_iterations = 60;
    const Tangent                   *tangent         = nullptr;
    bool                             pivoting        = false;
    std::unique_ptr<CondensedFactor> factors;
    Age                              age;
  };

  static const Register<LinearSolver, KeptFactor>
    kept_factor("kept factor",
                "MUMPS in single precision, the factors kept as preconditioner "
                "of FGMRES for as long as they are worth it.");
} // namespace lumbricus
