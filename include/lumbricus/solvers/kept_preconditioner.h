// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_solvers_kept_preconditioner_h
#define lumbricus_solvers_kept_preconditioner_h

#include <lumbricus/core/exceptions.h>
#include <lumbricus/solvers/factor_age.h>
#include <lumbricus/solvers/linear_solver.h>

#include <deal.II/base/timer.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>

#include <memory>
#include <string>

namespace lumbricus
{
  /**
   * FGMRES, preconditioned by an approximate inverse of an earlier tangent,
   * which is kept across Newton iterations, resets and load steps for as long
   * as the iterations it costs are fewer than a new one is worth.
   *
   * An @p Inverse is made for a pattern and has factor(), to be computed from
   * what the tangent is now, vmult(), and cost(), that of factor() in
   * applications of vmult().
   */
  template <class Inverse>
  class KeptPreconditioner : public LinearSolver
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
      prm.add_parameter("Least accuracy",
                        least_accuracy,
                        "[-] Solve to this relative residual or a smaller one, "
                        "whatever Newton's method asks for.",
                        dealii::Patterns::Double(0., 1.));
      prm.add_parameter("Keep",
                        keep,
                        "Whether factors are kept for other tangents than the "
                        "one they are of.");
    }

    void
    reinit(const Tangent &new_tangent) override
    {
      tangent = &new_tangent;
      inverse.reset();
    }

    void
    solve(CellVector       &x,
          const CellVector &b,
          const double      wanted_tolerance) override
    {
      const double tolerance = std::min(wanted_tolerance, least_accuracy);
      const bool   fresh =
        inverse == nullptr || !keep || age.worn_out(inverse->cost());
      if (fresh)
        factor();
      x              = 0.;
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

  protected:
    virtual std::unique_ptr<Inverse>
    make_inverse(const Tangent &of) const = 0;

  private:
    void
    factor()
    {
      dealii::Timer timer;
      if (inverse == nullptr)
        inverse = make_inverse(*tangent);
      inverse->factor();
      age = FactorAge();
      ++counts.n_factorisations;
      counts.factor_seconds += timer.wall_time();
    }

    /** Go on from @p x; @return whether FGMRES converged. */
    bool
    iterate(CellVector &x, const CellVector &b, const double tolerance)
    {
      dealii::Timer         timer;
      dealii::SolverControl control(most_iterations, tolerance * b.l2_norm());
      dealii::SolverFGMRES<CellVector> solver(
        control,
        dealii::SolverFGMRES<CellVector>::AdditionalData(most_iterations));
      bool converged = true;
      try
        {
          solver.solve(*tangent, x, b, *inverse);
        }
      catch (const dealii::SolverControl::NoConvergence &)
        {
          converged = false;
        }
      age.solved(control.last_step(), tolerance);
      counts.n_iterations += control.last_step();
      counts.most_iterations =
        std::max(counts.most_iterations, control.last_step());
      counts.solve_seconds += timer.wall_time();
      return converged;
    }

    unsigned int             most_iterations = 60;
    double                   least_accuracy  = 1.;
    bool                     keep            = true;
    const Tangent           *tangent         = nullptr;
    std::unique_ptr<Inverse> inverse;
    FactorAge                age;
  };
} // namespace lumbricus

#endif
