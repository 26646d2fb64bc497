// SPDX-License-Identifier: LGPL-2.1-or-later
// Estimators and rules that mark cells.
#include <lumbricus/adaptivity/jump_estimator.h>
#include <lumbricus/adaptivity/marking_rule.h>

#include <deal.II/base/symmetric_tensor.h>

#include <gtest/gtest.h>

#include "read_plugin.h"

using namespace lumbricus;

namespace
{
  std::unique_ptr<JumpEstimator>
  read_flux(const std::string &name)
  {
    auto estimator = read_plugin<ErrorEstimator>(name);
    auto jumps     = dynamic_cast<JumpEstimator *>(estimator.release());
    return std::unique_ptr<JumpEstimator>(jumps);
  }
} // namespace



TEST(Estimators, Fluxes)
{
  dealii::Tensor<2, dim> F = dealii::unit_symmetric_tensor<dim>(), P;
  F[0][1]                  = 0.5;
  P[2][0]                  = 3.;
  const auto kelly         = read_flux("displacement jump");
  EXPECT_EQ(kelly->flux(2., F, P)[0][1], 1.);
  EXPECT_EQ(kelly->flux(2., F, P).norm(), 1.);
  EXPECT_FALSE(kelly->continuous_between_tissues());
  const auto stress = read_flux("stress jump");
  EXPECT_EQ(stress->flux(2., F, P), P);
  EXPECT_TRUE(stress->continuous_between_tissues());
}



TEST(MarkingRules, FractionOfCells)
{
  const auto rule =
    read_plugin<MarkingRule>("fraction of cells",
                             "set Refine = 0.1\nset Merge = 0.4");
  const auto counts = rule->counts({9., 4., 1.}, {1., 2.}, {40, 1600});
  EXPECT_EQ(counts.refined, 4u);
  // 16 of 40 cells, in families of eight.
  EXPECT_EQ(counts.merged, 2u);
}



TEST(MarkingRules, FractionOfErrorTakesTheFewestCells)
{
  const auto rule =
    read_plugin<MarkingRule>("fraction of error",
                             "set Refine = 0.6\nset Merge = 0.1");
  // The sum is 20: 9 + 5 >= 12 > 9, and 0.5 + 1 <= 2 < 0.5 + 1 + 1.
  const auto counts =
    rule->counts({9., 5., 3., 2., 1.}, {0.5, 1., 1.}, {5, 200});
  EXPECT_EQ(counts.refined, 2u);
  EXPECT_EQ(counts.merged, 2u);
  const auto none = rule->counts({}, {}, {5, 200});
  EXPECT_EQ(none.refined + none.merged, 0u);
}



TEST(MarkingRules, NumberOfUnknowns)
{
  const auto rule =
    read_plugin<MarkingRule>("number of unknowns",
                             "set Target = 10000\nset Refine = 0.5\n"
                             "set Merge = 0.08");
  const std::vector<double> families(100, 1.);
  // 40 unknowns a cell. From 180 cells to 250, and one family makes way: room
  // for 77 cells, eleven more refined.
  const auto below = rule->counts({}, families, {180, 7200});
  EXPECT_EQ(below.merged, 1u);
  EXPECT_EQ(below.refined, 11u);
  // Far below not more than half of the cells at once.
  EXPECT_EQ(rule->counts({}, families, {10, 400}).refined, 5u);
  // From 390 cells to 250: twenty families, and nothing refined.
  const auto above = rule->counts({}, families, {390, 15600});
  EXPECT_EQ(above.merged, 20u);
  EXPECT_EQ(above.refined, 0u);
}
