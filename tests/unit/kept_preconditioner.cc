// SPDX-License-Identifier: LGPL-2.1-or-later
// A linear solver that has failed can be used again, whatever made it fail.
// First seen with multigrid that did not converge: giving up the last kind of
// preconditioner it let go of it, threw, and still took itself to have one. The
// load step was cut, the next solve ended with SIGSEGV.
#include <gtest/gtest.h>

#include <lumbricus/core/exceptions.h>
#include <lumbricus/linear/full_factor.h>
#include <lumbricus/linear/kept_preconditioner.h>

#include <new>
#include <string>

#include "specimen.h"

using namespace lumbricus;

namespace
{
  enum class Fails
  {
    nowhere,
    making,
    factoring,
    factoring_singular,
    applying,
    converging
  };

  class Inverse : public ApproximateInverse
  {
  public:
    Inverse(const Tangent &tangent, const Fails &fails)
      : factors(tangent, tangent.space.communicator())
      , fails(fails)
    {}

    void
    factor() override
    {
      if (fails == Fails::factoring)
        throw std::bad_alloc();
      AssertThrow(fails != Fails::factoring_singular,
                  ExcNotConverged("singular"));
      factors.factor();
      ready = true;
    }

    void
    vmult(Vector &y, const Vector &x) const override
    {
      ASSERT_TRUE(ready);
      if (fails == Fails::applying)
        throw std::bad_alloc();
      factors.vmult(y, x);
      if (fails == Fails::converging)
        y = x;
    }

    double
    cost() const override
    {
      return 10.;
    }

  private:
    FullFactor   factors;
    const Fails &fails;
    bool         ready = false;
  };

  class Kept : public KeptPreconditioner
  {
  public:
    Fails        fails   = Fails::nowhere;
    unsigned int n_kinds = 1;

  private:
    InverseKind
    make(const Tangent &tangent, const unsigned int kind) override
    {
      if (kind >= n_kinds)
        return {};
      if (fails == Fails::making)
        throw std::bad_alloc();
      return {"kind " + std::to_string(kind),
              std::make_unique<Inverse>(tangent, fails)};
    }
  };

  class KeptPreconditioners : public ::testing::TestWithParam<Fails>
  {
  protected:
    KeptPreconditioners()
      : body("subsection Geometry\n set Shape = block\n"
             " subsection block\n  set Cells = 2, 2, 2\n end\nend\n")
    {
      auto &model = *body.model;
      model.references.update(body.state);
      model.equilibrium.set_time(0., body.state.solution);
      body.state.solution.add(1., body.random(1e-3, 1));
      model.assembler.linearise(body.state.solution, 0.);
      solver.reinit(tangent());
    }

    const Tangent &
    tangent() const
    {
      return body.model->assembler.tangent();
    }

    void
    solve(const double tolerance = 1e-8)
    {
      const Vector &b = body.model->assembler.right_hand_side();
      Vector        x(b), r(b);
      solver.solve(x, b, tolerance);
      tangent().vmult(r, x);
      r -= b;
      EXPECT_LT(r.l2_norm(), 2. * tolerance * b.l2_norm());
    }

    Specimen body;
    Kept     solver;
  };

  INSTANTIATE_TEST_SUITE_P(Fails,
                           KeptPreconditioners,
                           ::testing::Values(Fails::making,
                                             Fails::factoring,
                                             Fails::factoring_singular,
                                             Fails::applying,
                                             Fails::converging));



  TEST_P(KeptPreconditioners, CanBeUsedAfterTheyHaveFailed)
  {
    for (const unsigned int n_kinds : {1u, 2u})
      for (const bool at_first : {true, false})
        {
          solver.n_kinds = n_kinds;
          solver.fails   = Fails::nowhere;
          solver.reinit(tangent());
          if (!at_first)
            solve();
          // With kept factors only what is done with them can fail.
          solver.fails = GetParam();
          const bool tries =
            at_first || solver.fails == Fails::applying ||
            solver.fails == Fails::converging;
          for (unsigned int again = 0; again < 2; ++again)
            {
              bool failed = false;
              try
                {
                  solve();
                }
              catch (...)
                {
                  failed = true;
                }
              EXPECT_EQ(failed, tries);
            }
          solver.fails = Fails::nowhere;
          EXPECT_NO_THROW(solve());
        }
  }
} // namespace
