// SPDX-License-Identifier: LGPL-2.1-or-later
// Viscous branches of tissues at a point, and what a state remembers of them.
#include <lumbricus/anatomy/viscous_branch.h>
#include <lumbricus/core/nodal_history.h>
#include <lumbricus/discretization/element_kernel.h>
#include <lumbricus/discretization/viscous_memory.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>
#include <deal.II/base/types.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "sample_point.h"
#include "specimen.h"

using namespace lumbricus;
using namespace lumbricus::sample_point;
using dealii::SymmetricTensor;
using dealii::Tensor;

namespace
{
  constexpr double modulus = 0.8, relaxation_time = 0.5;

  // A branch, where the body was one step ago, and what it remembered there.
  class Branch : public ViscousBranch
  {
  public:
    Branch()
      : ViscousBranch("branch")
    {
      dealii::ParameterHandler prm;
      declare_parameters(prm);
      prm.parse_input_from_string("set Shear modulus = 0.8\n"
                                  "set Relaxation time = 0.5\n");
      b[0][0] = 1.2;
      b[1][1] = 0.7;
      b[2][2] = 1.4;
      b[0][1] = 0.3;
      b[1][2] = -0.2;
    }

    ViscousPoint
    after(const double dt) const
    {
      return in_step(b, inverse_shape(F_before), dt);
    }

    const Tensor<2, dim> F_before =
      gradient({1.1, 0., 0.2, -0.1, 0.9, 0., 0.1, 0.2, 1.2});
    SymmetricTensor<2, dim> b;
  };



  MaterialResponse
  response(const ViscousBranch  &branch,
           const Tensor<2, dim> &F,
           const ViscousPoint   &point)
  {
    MaterialResponse sum{};
    branch.add_stress(F, point, true, sum);
    return sum;
  }



  // The change of shape C J^(-2/3).
  SymmetricTensor<2, dim>
  shape(const Tensor<2, dim> &F)
  {
    return invert(inverse_shape(F));
  }
} // namespace



TEST(Viscosity, StressAndTangentAreDerivatives)
{
  const Branch branch;
  for (const double dt : {0., 0.1, 3.})
    {
      const ViscousPoint     point = branch.after(dt);
      const auto             b     = point.at_end(F_general);
      const MaterialResponse at    = response(branch, F_general, point);
      EXPECT_GT(at.P.norm(), 0.05);
      for (unsigned int k = 0; k < dim; ++k)
        for (unsigned int L = 0; L < dim; ++L)
          {
            Tensor<2, dim> F_plus = F_general, F_minus = F_general;
            F_plus[k][L] += h;
            F_minus[k][L] -= h;
            // With what is remembered at the end held fast.
            EXPECT_NEAR(at.P[k][L],
                        (branch.energy(F_plus, b) - branch.energy(F_minus, b)) /
                          (2 * h),
                        1e-9)
              << dt;
            const Tensor<2, dim> slope =
              (response(branch, F_plus, point).P -
               response(branch, F_minus, point).P) /
              (2 * h);
            for (unsigned int i = 0; i < dim; ++i)
              for (unsigned int J = 0; J < dim; ++J)
                {
                  EXPECT_NEAR(at.A[dim * i + J][dim * k + L], slope[i][J], 1e-8)
                    << dt;
                  EXPECT_NEAR(at.A[dim * i + J][dim * k + L],
                              at.A[dim * k + L][dim * i + J],
                              1e-14);
                }
          }
    }
}



TEST(Viscosity, IsTheSameTurnedAndOfAnyVolume)
{
  const Branch       branch;
  const ViscousPoint point = branch.after(0.2);
  const double       c = std::cos(0.7), s = std::sin(0.7);
  const auto R = gradient({c, -s, 0., s, c, 0., 0., 0., 1.}) *
                 gradient({1., 0., 0., 0., c, -s, 0., s, c});
  const auto   at = response(branch, F_general, point);
  const auto   b  = point.at_end(F_general);
  const double lost = branch.dissipated(branch.F_before, F_general, point);
  EXPECT_GT(lost, 0.);
  for (const double size : {1., 1.3})
    {
      const Tensor<2, dim> F = size * R * F_general;
      EXPECT_LT((size * response(branch, F, point).P - R * at.P).norm(), 1e-14);
      EXPECT_LT((point.at_end(F) - b).norm(), 1e-14);
      EXPECT_NEAR(branch.energy(F, b), branch.energy(F_general, b), 1e-14);
      EXPECT_NEAR(branch.dissipated(R * branch.F_before, F, point), lost, 1e-14);
    }
  // No pressure, since P : F is none.
  EXPECT_NEAR(scalar_product(at.P, F_general), 0., 1e-14);
}



TEST(Viscosity, HeldStressRelaxesExactly)
{
  const Branch           branch;
  const Tensor<2, dim>   P = response(branch, branch.F_before, branch.after(0.)).P;
  const double           energy = branch.energy(branch.F_before, branch.b);
  for (const double dt : {1e-6, 0.1, 0.7, 20.})
    {
      const ViscousPoint point = branch.after(dt);
      EXPECT_LT((response(branch, branch.F_before, point).P -
                 std::exp(-dt / relaxation_time) * P)
                  .norm(),
                1e-15)
        << dt;
      // What is no longer stored is dissipated, but for the mean of b^(-1).
      const double lost =
        branch.dissipated(branch.F_before, branch.F_before, point);
      const double fallen =
        energy - branch.energy(branch.F_before, point.at_end(branch.F_before));
      EXPECT_NEAR(lost / fallen, 1., dt < 1e-3 ? 1e-5 : 0.2) << dt;
    }
}



TEST(Viscosity, ManyStepsGoAlongTheDifferentialEquation)
{
  // db/dt = (Cbar^(-1) - b)/tau and what is dissipated, along a motion, in one
  // step of Runge and Kutta for each of ours: our error is of second order.
  const Branch branch;
  const auto   F_at = [&](const double t) {
    return branch.F_before + t * t * (F_general - branch.F_before);
  };
  struct Rates
  {
    SymmetricTensor<2, dim> b;
    double                  lost;
  };
  const auto rates = [&](const double t, const SymmetricTensor<2, dim> &b) {
    const auto Cbar = shape(F_at(t)), inverse = inverse_shape(F_at(t));
    return Rates{(inverse - b) / relaxation_time,
                 modulus / (2. * relaxation_time) *
                   (Cbar * b + invert(b) * inverse - 6.)};
  };
  double error_b = 0., error_lost = 0.;
  for (const unsigned int n : {40, 80})
    {
      const double            dt = 1. / n;
      SymmetricTensor<2, dim> b = branch.b, exact = branch.b;
      double                  lost = 0., exact_lost = 0.;
      for (unsigned int i = 0; i < n; ++i)
        {
          const double       t = i * dt;
          const ViscousPoint point =
            branch.in_step(b, inverse_shape(F_at(t)), dt);
          lost += branch.dissipated(F_at(t), F_at(t + dt), point);
          b = point.at_end(F_at(t + dt));
          const auto k1 = rates(t, exact);
          const auto k2 = rates(t + dt / 2, exact + dt / 2 * k1.b);
          const auto k3 = rates(t + dt / 2, exact + dt / 2 * k2.b);
          const auto k4 = rates(t + dt, exact + dt * k3.b);
          exact += dt / 6 * (k1.b + 2. * k2.b + 2. * k3.b + k4.b);
          exact_lost += dt / 6 * (k1.lost + 2 * k2.lost + 2 * k3.lost + k4.lost);
        }
      const double more_b = (b - exact).norm();
      const double more   = std::abs(lost - exact_lost);
      EXPECT_LT(more_b, 1e-3);
      EXPECT_LT(more, 1e-3 * exact_lost);
      if (n == 80)
        {
          EXPECT_NEAR(error_b / more_b, 4., 0.5);
          EXPECT_NEAR(error_lost / more, 4., 1.);
        }
      error_b    = more_b;
      error_lost = more;
    }
}



TEST(Viscosity, EveryStepDissipates)
{
  // There and back, in steps of any length; b stays positive definite.
  const Branch branch;
  for (const double dt : {1e-5, 0.009, 0.011, 0.3, 5., 1e4})
    {
      SymmetricTensor<2, dim> b = branch.b;
      Tensor<2, dim>          F = branch.F_before;
      for (const Tensor<2, dim> &next :
           {F_general, branch.F_before, branch.F_before, F_general})
        {
          const ViscousPoint point = branch.in_step(b, inverse_shape(F), dt);
          EXPECT_GT(branch.dissipated(F, next, point), 0.) << dt;
          b = point.at_end(next);
          F = next;
          for (const double value : eigenvalues(b))
            EXPECT_GT(value, 0.);
        }
    }
}



TEST(Viscosity, StateRemembersAllThatPointsHave)
{
  // Two tissues, one with two branches and one with none, in a body that is bent in
  // some way: after the step the points have what they had at its end.
  Specimen    body(R"(
subsection Geometry
  set Shape = open cylinder
  subsection open cylinder
    set Filled                       = false
    set Wall layers                  = inner, outer
    set Wall layer thicknesses       = 0.5, 0.5
    set Cells across each wall layer = 1
    set Cells along the cylinder     = 2
  end
end
subsection Tissues
  subsection inner
    subsection Viscous branches
      set Names = slow, quick
      subsection slow
        set Shear modulus   = 0.8
        set Relaxation time = 0.5
      end
      subsection quick
        set Shear modulus   = 2
        set Relaxation time = 0.01
      end
    end
  end
end
)");
  ChainModel &model = *body.model;
  State      &state = body.state;
  EXPECT_EQ(model.body.anatomy.n_viscous_branches(), 2u);
  for (const std::string name :
       {"branch:0:0", "branch:0:1", "branch:1:0", "branch:1:1", "u_before"})
    EXPECT_EQ(state.histories.count(name), 1u) << name;

  std::vector<SymmetricTensor<2, dim>> before, after;
  const auto                           collect =
    [&](std::vector<SymmetricTensor<2, dim>> &all) {
      const Vector  relevant = model.space.with_ghosts(state.solution);
      ElementKernel kernel;
      std::vector<dealii::types::global_dof_index> indices(
        model.space.fe.n_dofs_per_cell());
      for (const OwnedCell cell : model.body.owned_cells())
        {
          kernel.read(model.space, cell.iterator, relevant, indices);
          kernel.compute_deformation(model.shapes.cell(cell.index));
          for (unsigned int q = 0; q < MixedSpace::n_q_points; ++q)
            {
              const auto &viscous =
                model.references.cell(cell.index)[q].viscous;
              EXPECT_EQ(viscous.size(), cell.tissue.name() == "inner" ? 2u : 0u);
              for (const ViscousPoint &point : viscous)
                all.push_back(point.at_end(kernel.F[q]));
            }
        }
    };
  for (const double t : {0.1, 0.3})
    {
      state.time     = t;
      state.solution = body.random(0.03, 1 + 10 * t);
      model.references.update(state);
      before.clear();
      collect(before);
      model.end_step(state);
      model.references.update(state);
      after.clear();
      collect(after);
      ASSERT_EQ(after.size(), before.size());
      double far = 0., different = 0.;
      for (unsigned int i = 0; i < after.size(); ++i)
        {
          different = std::max(different, (after[i] - before[i]).norm());
          far       = std::max(far, (after[i] - after[0]).norm());
        }
      EXPECT_LT(different, 1e-13);
      EXPECT_GT(far, 0.01);
    }
}
