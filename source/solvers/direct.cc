// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/registry.h>
#include <lumbricus/solvers/linear_solver.h>
#include <lumbricus/solvers/mumps.h>

#include <deal.II/base/timer.h>

namespace lumbricus
{
  /** A factorisation for every matrix. */
  class Direct : public LinearSolver
  {
  public:
    void
    reinit(const bool is_symmetric) override
    {
      symmetric = is_symmetric;
      factors.reset();
    }

    void
    set_matrix(const Matrix &A) override
    {
      dealii::Timer timer;
      if (factors == nullptr)
        factors = std::make_unique<Mumps>(A.get_mpi_communicator(), symmetric);
      factors->factor(A);
      ++counts.n_factorisations;
      counts.factor_seconds += timer.wall_time();
    }

    void
    solve(Vector &x, const Vector &b, const double /*tolerance*/) override
    {
      dealii::Timer timer;
      factors->solve(x, b);
      ++counts.n_solves;
      ++counts.n_iterations;
      counts.solve_seconds += timer.wall_time();
    }

  private:
    bool                   symmetric = true;
    std::unique_ptr<Mumps> factors;
  };

  static const Register<LinearSolver, Direct>
    direct("direct", "MUMPS, with a factorisation for every Newton iteration.");
} // namespace lumbricus
