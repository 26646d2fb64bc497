// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/linear/bordered_system.h>
#include <lumbricus/linear/flexible_gmres.h>
#include <lumbricus/linear/kept_preconditioner.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/timer.h>

#include <algorithm>
#include <utility>

namespace lumbricus
{
  namespace
  {
    // An inverse of a tangent with its border, as Krylov methods see it.
    struct FactoredWithBorder
    {
      const ApproximateInverse &inverse;

      void
      vmult(BorderedVector &y, const BorderedVector &x) const
      {
        inverse.vmult_bordered(y, x);
      }
    };
  } // namespace



  KeptPreconditioner::KeptPreconditioner()  = default;
  KeptPreconditioner::~KeptPreconditioner() = default;



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
    bordered.reset();
    current            = {};
    factored           = false;
    n_factored_globals = 0;
  }



  void
  KeptPreconditioner::solve(Vector       &x,
                            const Vector &b,
                            const double  wanted_tolerance)
  {
    const double tolerance = std::min(wanted_tolerance, least_accuracy);
    if (n_factored_globals > 0)
      factored = false;
    solve_by(
      [&]() { return iterate(*tangent, *current.inverse, x, b, tolerance); },
      nullptr);
  }



  void
  KeptPreconditioner::solve_bordered(Vector                    &x,
                                     std::vector<double>       &g,
                                     const Vector              &b,
                                     const std::vector<double> &c,
                                     const Border              &border,
                                     const double wanted_tolerance)
  {
    const double tolerance = std::min(wanted_tolerance, least_accuracy);
    const BorderedVector  all_b = bordered_vector(b, c);
    BorderedVector        all_x = all_b;
    const BorderedTangent system(*tangent, border);
    // An earlier border may have had others of the same number, which hardly
    // help then: iterations will say so.
    if (bordered != nullptr && bordered->size() != border.size())
      bordered.reset();
    if (n_factored_globals > 0 && n_factored_globals != border.size())
      factored = false;
    const auto iterate_bordered = [&]() {
      if (n_factored_globals > 0)
        return iterate(system,
                       FactoredWithBorder{*current.inverse},
                       all_x,
                       all_b,
                       tolerance);
      if (bordered == nullptr)
        {
          dealii::Timer timer;
          bordered =
            std::make_unique<BorderedInverse>(*current.inverse, border, b);
          counts.factor_seconds += timer.wall_time();
        }
      return iterate(system, *bordered, all_x, all_b, tolerance);
    };
    solve_by(
      [&]() {
        return iterate_bordered() && system.is_solved(all_x, all_b, tolerance);
      },
      &border);
    x = all_x.block(0);
    g = globals_of(all_x);
  }



  void
  KeptPreconditioner::solve_by(const std::function<bool()> &iterate,
                               const Border                *border)
  {
    try
      {
        const double cost_of_border = bordered ? bordered->size() : 0.;
        const bool   worth_keeping =
          factored && keep &&
          !age.worn_out(current.inverse->cost() + cost_of_border);
        bool solved = worth_keeping && iterate();
        while (!solved)
          {
            solved = factor(border) && iterate();
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
  KeptPreconditioner::factor(const Border *border)
  {
    dealii::Timer timer;
    factored           = false;
    n_factored_globals = 0;
    bordered.reset();
    if (current.inverse == nullptr)
      current = make(*tangent, kind);
    age = FactorAge();
    ++counts.n_factorisations;
    try
      {
        if (border != nullptr && current.inverse->factor_bordered(*border))
          n_factored_globals = border->size();
        else
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



  template <typename System, typename Inverse, typename VectorType>
  bool
  KeptPreconditioner::iterate(const System     &system,
                              const Inverse    &inverse,
                              VectorType       &x,
                              const VectorType &b,
                              const double      tolerance)
  {
    dealii::Timer             timer;
    FlexibleGmres<VectorType> solver(most_iterations);
    const bool                converged = solver.solve(
      [&](VectorType &y, const VectorType &v) { system.vmult(y, v); },
      [&](VectorType &y, const VectorType &v) { inverse.vmult(y, v); },
      x,
      b,
      tolerance);
    age.solved(solver.n_iterations(), tolerance);
    count_iterations(solver.n_iterations());
    counts.solve_seconds += timer.wall_time();
    return converged;
  }
} // namespace lumbricus
