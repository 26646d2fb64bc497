// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/registry.h>
#include <lumbricus/solvers/linear_solver.h>
#include <lumbricus/solvers/mumps.h>

#include <deal.II/base/timer.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>

namespace lumbricus
{
  /**
   * FGMRES, preconditioned by a factorisation of an earlier matrix, which is
   * kept across Newton iterations, resets and load steps; a new one is made
   * when the iterations are too many.
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
                        "factored again.",
                        dealii::Patterns::Integer(1));
    }

    void
    reinit(const bool is_symmetric) override
    {
      symmetric = is_symmetric;
      matrix    = nullptr;
      factors.reset();
    }

    void
    set_matrix(const Matrix &A) override
    {
      matrix = &A;
      fresh  = false;
    }

    void
    solve(Vector &x, const Vector &b, const double tolerance) override
    {
      if (factors == nullptr)
        factor();
      bool converged = iterate(x, b, tolerance);
      if (!converged && !fresh)
        {
          factor();
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
    void
    factor()
    {
      dealii::Timer timer;
      if (factors == nullptr)
        factors =
          std::make_unique<Mumps>(matrix->get_mpi_communicator(), symmetric);
      factors->factor(*matrix);
      fresh = true;
      ++counts.n_factorisations;
      counts.factor_seconds += timer.wall_time();
    }

    /** @return whether FGMRES converged. */
    bool
    iterate(Vector &x, const Vector &b, const double tolerance)
    {
      struct Preconditioner
      {
        Mumps &factors;

        void
        vmult(Vector &y, const Vector &r) const
        {
          factors.solve(y, r);
        }
      };

      dealii::Timer         timer;
      dealii::SolverControl control(most_iterations, tolerance * b.l2_norm());
      dealii::SolverFGMRES<Vector> solver(
        control, dealii::SolverFGMRES<Vector>::AdditionalData(most_iterations));
      bool converged = true;
      x              = 0.;
      try
        {
          solver.solve(*matrix, x, b, Preconditioner{*factors});
        }
      catch (const dealii::SolverControl::NoConvergence &)
        {
          converged = false;
        }
      counts.n_iterations += control.last_step();
      counts.solve_seconds += timer.wall_time();
      return converged;
    }

    unsigned int           most_iterations = 25;
    bool                   symmetric       = true;
    bool                   fresh           = false;
    const Matrix          *matrix          = nullptr;
    std::unique_ptr<Mumps> factors;
  };

  static const Register<LinearSolver, KeptFactor>
    kept_factor("kept factor",
                "MUMPS, the factors kept as preconditioner of FGMRES for as "
                "long as they are good.");
} // namespace lumbricus
