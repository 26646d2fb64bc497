// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/linear/full_factor.h>
#include <lumbricus/linear/linear_solver.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/timer.h>

#include <memory>

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

    void
    solve(Vector &x, const Vector &b, const double tolerance) override
    {
      dealii::Timer timer;
      if (factors == nullptr)
        factors =
          std::make_unique<FullFactor>(*tangent, tangent->space.communicator());
      factors->factor();
      ++counts.n_factorisations;
      counts.factor_seconds += timer.wall_time();

      // Iterative refinement makes up for pivots that were not the best.
      timer.restart();
      constexpr unsigned int most_refinements = 3;
      Vector                 r(b), correction(b);
      x              = 0.;
      unsigned int n = 1;
      for (;; ++n)
        {
          factors->vmult(correction, r);
          x += correction;
          tangent->vmult(r, x);
          r.sadd(-1., 1., b);
          if (n > most_refinements || r.l2_norm() <= tolerance * b.l2_norm())
            break;
        }
      count_iterations(n);
      ++counts.n_solves;
      counts.solve_seconds += timer.wall_time();
    }

  private:
    const Tangent              *tangent = nullptr;
    std::unique_ptr<FullFactor> factors;
  };

  static const Register<LinearSolver, Direct>
    direct("direct", "MUMPS, with a factorisation for every Newton iteration.");
} // namespace lumbricus
