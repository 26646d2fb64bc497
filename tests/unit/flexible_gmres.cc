// SPDX-License-Identifier: LGPL-2.1-or-later
// FGMRES with few reductions takes the iterations that deal.II's takes with
// modified Gram and Schmidt, also where the preconditioner is nearly the inverse,
// what is left of a vector is small and rounding would spoil the basis; it applies
// the operators once for each iteration; and it ends where there is nothing to solve
// or no way to.
#include <lumbricus/core/state.h>
#include <lumbricus/linear/approximate_inverse.h>
#include <lumbricus/linear/flexible_gmres.h>

#include <deal.II/base/index_set.h>
#include <deal.II/base/mpi.h>
#include <deal.II/lac/solver_control.h>
#include <deal.II/lac/solver_gmres.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace lumbricus;

namespace
{
  using Solver = FlexibleGmres<Vector>;

  // y_i = d_i x_i + u_i (w . x), not symmetric, the same on any number of ranks.
  struct Operator
  {
    double       spread; // of d
    double       coupling;
    mutable unsigned int n_applications = 0;

    void
    vmult(Vector &y, const Vector &x) const
    {
      ++n_applications;
      double product = 0.;
      for (const auto i : x.locally_owned_elements())
        product += std::cos(1. + 3. * i) * x(i);
      product =
        dealii::Utilities::MPI::sum(product, x.get_mpi_communicator());
      for (const auto i : x.locally_owned_elements())
        y(i) = (1. + spread * std::abs(std::sin(2. + 5. * i))) * x(i) +
               coupling * std::sin(1. + i) * product;
    }
  };



  class FlexibleGmreses : public ::testing::Test
  {
  protected:
    FlexibleGmreses()
    {
      const unsigned int rank = dealii::Utilities::MPI::this_mpi_process(comm);
      const unsigned int n_ranks =
        dealii::Utilities::MPI::n_mpi_processes(comm);
      dealii::IndexSet owned(n);
      owned.add_range(n * rank / n_ranks, n * (rank + 1) / n_ranks);
      b.reinit(owned, comm);
      for (const auto i : owned)
        b(i) = std::sin(7. + 11. * i);
      x = b;
    }

    // A preconditioner that does nothing.
    static void
    nothing(Vector &y, const Vector &v)
    {
      y = v;
    }

    template <typename System>
    double
    residual(const System &A) const
    {
      Vector r(b);
      A.vmult(r, x);
      r -= b;
      return r.l2_norm() / b.l2_norm();
    }

    static constexpr unsigned int n    = 3000;
    const MPI_Comm                comm = MPI_COMM_WORLD;
    Vector                        b, x;
  };



  TEST_F(FlexibleGmreses, TakeAsManyIterationsAsModifiedGramAndSchmidt)
  {
    // From far from the inverse to close to it.
    for (const double spread : {30., 3., .1, 1e-4})
      for (const double tolerance : {1e-3, 1e-9})
        {
          const Operator A{spread, spread / n};
          Solver         solver(60);
          ASSERT_TRUE(solver.solve(
            [&](Vector &y, const Vector &v) { A.vmult(y, v); },
            nothing,
            x,
            b,
            tolerance));
          EXPECT_EQ(A.n_applications, solver.n_iterations());
          EXPECT_LT(residual(A), 1.001 * tolerance);

          struct Identity
          {
            void
            vmult(Vector &y, const Vector &v) const
            {
              y = v;
            }
          };
          dealii::SolverControl        control(60, tolerance * b.l2_norm());
          dealii::SolverFGMRES<Vector> reference(
            control, dealii::SolverFGMRES<Vector>::AdditionalData(60));
          x = 0.;
          reference.solve(A, x, b, Identity());
          EXPECT_EQ(solver.n_iterations(), control.last_step())
            << spread << " " << tolerance;
        }
  }



  // Once is enough for a few of them only.
  TEST_F(FlexibleGmreses, RepeatWhatRoundingSpoils)
  {
    const Operator A{30., 30. / n};
    Solver         solver(60);
    const auto     vmult = [&](Vector &y, const Vector &v) { A.vmult(y, v); };
    ASSERT_TRUE(solver.solve(vmult, nothing, x, b, 1e-2));
    EXPECT_GT(solver.n_iterations(), 2u);
    EXPECT_EQ(solver.n_repeated(), 0u);
    ASSERT_TRUE(solver.solve(vmult, nothing, x, b, 1e-12));
    EXPECT_GT(solver.n_repeated(), 0u);
    EXPECT_LT(solver.n_repeated(), solver.n_iterations());
    EXPECT_LT(residual(A), 1.001e-12 + 1e-14);
  }



  TEST_F(FlexibleGmreses, EndWhereThereIsNothingToDo)
  {
    Solver solver(60);
    b = 0.;
    EXPECT_TRUE(solver.solve(nothing, nothing, x, b, 1e-6));
    EXPECT_EQ(solver.n_iterations(), 0u);
    EXPECT_EQ(x.l2_norm(), 0.);
  }



  TEST_F(FlexibleGmreses, SayThatTheyDoNotConverge)
  {
    const Operator A{30., 1.};
    Solver         solver(3);
    EXPECT_FALSE(
      solver.solve([&](Vector &y, const Vector &v) { A.vmult(y, v); },
                   nothing,
                   x,
                   b,
                   1e-9));
    EXPECT_EQ(solver.n_iterations(), 3u);
    EXPECT_LT(residual(A), 1.);
    // A matrix of zeros, and one that is no number.
    for (const double factor : {0., std::numeric_limits<double>::quiet_NaN()})
      {
        EXPECT_FALSE(solver.solve(
          [&](Vector &y, const Vector &v) {
            // Not by a function of the vector: in Debug those want numbers.
            for (unsigned int i = 0; i < y.locally_owned_size(); ++i)
              y.local_element(i) = factor * v.local_element(i);
          },
          nothing,
          x,
          b,
          1e-9));
        EXPECT_EQ(solver.n_iterations(), 1u);
        EXPECT_EQ(x.l2_norm(), 0.);
      }
  }



  TEST_F(FlexibleGmreses, SolveWithGlobalUnknowns)
  {
    dealii::IndexSet owned(4);
    if (dealii::Utilities::MPI::this_mpi_process(comm) == 0)
      owned.add_range(0, 4);
    BorderedVector all_b(2);
    all_b.block(0) = b;
    all_b.block(1).reinit(owned, comm);
    all_b.block(1) = 2.;
    all_b.collect_sizes();
    BorderedVector all_x(all_b);
    const Operator A{3., 0.};
    FlexibleGmres<BorderedVector> solver(60);
    ASSERT_TRUE(solver.solve(
      [&](BorderedVector &y, const BorderedVector &v) {
        A.vmult(y.block(0), v.block(0));
        y.block(1).equ(8., v.block(1));
      },
      [](BorderedVector &y, const BorderedVector &v) { y = v; },
      all_x,
      all_b,
      1e-8));
    x = all_x.block(0);
    EXPECT_LT(residual(A), 1e-7);
    for (const double value : all_x.block(1))
      EXPECT_NEAR(value, .25, 1e-7);
  }
} // namespace
