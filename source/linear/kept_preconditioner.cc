// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/linear/kept_preconditioner.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/timer.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>

#include <algorithm>
#include <utility>

namespace lumbricus
{
  void
  KeptPreconditioner::declare_parameters(dealii::ParameterHandler &prm)
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
  KeptPreconditioner::reinit(const Tangent &new_tangent)
  {
    // With as many unknowns as before only constraints are new: what did not
    // do then will not do now.
    const auto n = new_tangent.space.dof_handler.n_dofs();
    if (n != std::exchange(n_unknowns, n))
      kind = 0;
    tangent = &new_tangent;
    drop();
  }



  void
  KeptPreconditioner::drop()
  {
    current  = {};
    factored = false;
  }



  void
  KeptPreconditioner::solve(Vector       &x,
                            const Vector &b,
                            const double  wanted_tolerance)
  {
    const double tolerance = std::min(wanted_tolerance, least_accuracy);
    try
      {
        const bool worth_keeping =
          factored && keep && !age.worn_out(current.inverse->cost());
        bool solved = worth_keeping && iterate(x, b, tolerance);
        while (!solved)
          {
            solved = factor() && iterate(x, b, tolerance);
            if (!solved)
              give_up_kind();
          }
      }
    catch (...)
      {
        // Whatever it was, what is left may be half of an inverse. The next
        // solve, of a shorter load step or for the diagnosis, begins anew.
        drop();
        throw;
      }
    ++counts.n_solves;
  }



  bool
  KeptPreconditioner::factor()
  {
    dealii::Timer timer;
    factored = false;
    if (current.inverse == nullptr)
      current = make(*tangent, kind);
    age = FactorAge();
    ++counts.n_factorisations;
    try
      {
        current.inverse->factor();
        factored = true;
      }
    catch (const ExcNotConverged &)
      {}
    counts.factor_seconds += timer.wall_time();
    return factored;
  }



  void
  KeptPreconditioner::give_up_kind()
  {
    // Memory for one of them is enough.
    const std::string name         = current.name;
    const bool        was_factored = factored;
    drop();
    InverseKind next = make(*tangent, kind + 1);
    AssertThrow(next.inverse != nullptr,
                ExcNotConverged(
                  "The linear solver (" + name +
                  (was_factored ? ") does not reach its tolerance in " +
                                    std::to_string(most_iterations) +
                                    " iterations, even with new factors" :
                                  ") finds the tangent singular")));
    tell("The linear solver goes on with " + next.name + ", since " + name +
         (was_factored ? " needed more than " +
                           std::to_string(most_iterations) + " iterations" :
                         " could not be computed for this tangent") +
         ".");
    ++kind;
    current = std::move(next);
  }



  bool
  KeptPreconditioner::iterate(Vector       &x,
                              const Vector &b,
                              const double  tolerance)
  {
    dealii::Timer         timer;
    dealii::SolverControl control(most_iterations, tolerance * b.l2_norm());
    // With a basis of one vector FGMRES counts no iterations, and does not end.
    dealii::SolverFGMRES<Vector> solver(
      control,
      dealii::SolverFGMRES<Vector>::AdditionalData(
        std::max(2u, most_iterations)));
    bool converged = true;
    x              = 0.;
    try
      {
        solver.solve(*tangent, x, b, *current.inverse);
      }
    catch (const dealii::SolverControl::NoConvergence &)
      {
        converged = false;
      }
    age.solved(control.last_step(), tolerance);
    count_iterations(control.last_step());
    counts.solve_seconds += timer.wall_time();
    return converged;
  }
} // namespace lumbricus
