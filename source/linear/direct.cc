// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/linear/bordered_system.h>
#include <lumbricus/linear/full_factor.h>
#include <lumbricus/linear/linear_solver.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/timer.h>

#include <memory>
#include <string>
#include <vector>

namespace lumbricus
{
  /** A factorisation in double precision, of all free unknowns, for every
   * tangent. */
  class Direct : public LinearSolver
  {
  public:
    void
    reinit(const Tangent &new_tangent) override
    {
      tangent = &new_tangent;
      factors.reset();
    }

    using LinearSolver::solve;

    void
    solve(Vector &x, const Vector &b, const double tolerance) override
    {
      factor();
      refine(*tangent, *factors, x, b, tolerance);
    }

  protected:
    void
    solve_bordered(Vector                    &x,
                   std::vector<double>       &g,
                   const Vector              &b,
                   const std::vector<double> &c,
                   const Border              &border,
                   const double               tolerance) override
    {
      factor();
      const BorderedVector all_b = bordered_vector(b, c);
      BorderedVector       all_x = all_b;
      const BorderedTangent system(*tangent, border);
      refine(
        system, BorderedInverse(*factors, border, b), all_x, all_b, tolerance);
      AssertThrow(system.is_solved(all_x, all_b, tolerance),
                  ExcNotConverged(
                    "The linear system with " + std::to_string(c.size()) +
                    " global unknowns is not solved: without them the tangent "
                    "is singular, or nearly so"));
      x = all_x.block(0);
      g = globals_of(all_x);
    }

  private:
    /** Factor what the tangent is now. */
    void
    factor()
    {
      dealii::Timer timer;
      if (factors == nullptr)
        factors =
          std::make_unique<FullFactor>(*tangent, tangent->space.communicator());
      factors->factor();
      ++counts.n_factorisations;
      counts.factor_seconds += timer.wall_time();
    }

    /** Solve @p system with its factors @p inverse. Refinement makes up for
     * pivots that were not the best. */
    template <typename System, typename Inverse, typename VectorType>
    void
    refine(const System     &system,
           const Inverse    &inverse,
           VectorType       &x,
           const VectorType &b,
           const double      tolerance)
    {
      dealii::Timer          timer;
      constexpr unsigned int most_refinements = 3;
      VectorType             r(b), correction(b);
      x              = 0.;
      unsigned int n = 1;
      for (;; ++n)
        {
          inverse.vmult(correction, r);
          x += correction;
          system.vmult(r, x);
          r.sadd(-1., 1., b);
          if (n > most_refinements || r.l2_norm() <= tolerance * b.l2_norm())
            break;
        }
      count_iterations(n);
      ++counts.n_solves;
      counts.solve_seconds += timer.wall_time();
    }

    const Tangent              *tangent = nullptr;
    std::unique_ptr<FullFactor> factors;
  };

  static const Register<LinearSolver, Direct>
    direct("direct", "MUMPS, with a factorisation for every Newton iteration.");
} // namespace lumbricus
