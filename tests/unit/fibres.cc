// SPDX-License-Identifier: LGPL-2.1-or-later
// The fibre fields: unit length, right angles, and agreement with each other.
#include <lumbricus/fibres/fibre_field.h>

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>

#include <cmath>

#include "read_plugin.h"

using namespace lumbricus;
using dealii::Point;
using dealii::Tensor;

namespace
{
  const std::vector<Point<3>> points = {{0.3, 1.2, 0.7},
                                        {-5., -0.4, 2.},
                                        {12., -1e-3, -2e-3},
                                        {0., 0., 3.}};

  std::unique_ptr<FibreField>
  fibres(const std::string &name, const std::string &text = "")
  {
    auto result = read_plugin<FibreField>(name, text);
    result->initialize("biceps");
    return result;
  }

  void
  expect_equal(const Tensor<1, 3> &a, const Tensor<1, 3> &b)
  {
    EXPECT_NEAR((a - b).norm(), 0., 1e-14);
  }
} // namespace



TEST(Fibres, CylindricalFieldsAreARightHandedFrame)
{
  for (const auto &X : points)
    {
      const auto e_x     = fibres("longitudinal")->direction(X);
      const auto e_r     = fibres("radial")->direction(X);
      const auto e_theta = fibres("circumferential")->direction(X);
      EXPECT_NEAR(e_r.norm(), 1., 1e-14);
      EXPECT_NEAR(e_theta.norm(), 1., 1e-14);
      EXPECT_NEAR(e_r * e_theta, 0., 1e-14);
      EXPECT_NEAR(e_r * e_x, 0., 1e-14);
      expect_equal(dealii::cross_product_3d(e_x, e_r), e_theta);
      // e_r points away from the axis.
      EXPECT_NEAR(e_r * X, std::hypot(X[1], X[2]), 1e-14);
      expect_equal(e_x, Point<3>(1, 0, 0));
    }
}



TEST(Fibres, HelicalIsBetweenLongitudinalAndCircumferential)
{
  for (const auto &X : points)
    {
      const auto e_x     = fibres("longitudinal")->direction(X);
      const auto e_theta = fibres("circumferential")->direction(X);
      const auto at      = [&](const std::string &angle) {
        return fibres("helical", "set Angle = " + angle)->direction(X);
      };
      expect_equal(at("0"), e_x);
      expect_equal(at("90"), e_theta);
      expect_equal(at("60"), 0.5 * e_x + std::sqrt(0.75) * e_theta);
      expect_equal(at("-60"), 0.5 * e_x - std::sqrt(0.75) * e_theta);
      EXPECT_NEAR(at("33").norm(), 1., 1e-14);
      // Both families are mirror images.
      EXPECT_NEAR(at("45") * at("-45"), 0., 1e-14);
    }
}



TEST(Fibres, ExpressionAgreesWithHelical)
{
  const auto formulas = fibres("vector expression",
                               "set Formulas = sqrt(y^2+z^2)*cos(30*pi/180); "
                               "-z*sin(30*pi/180); y*sin(30*pi/180)");
  const auto helical  = fibres("helical", "set Angle = 30");
  for (const auto &X : points)
    expect_equal(formulas->direction(X), helical->direction(X));
}



TEST(Fibres, DirectionIsNormalised)
{
  const auto field = fibres("direction", "set Direction = 3, 0, -4");
  for (const auto &X : points)
    expect_equal(field->direction(X), Point<3>(0.6, 0, -0.8));
}



TEST(Fibres, NoDirectionIsAnErrorThatNamesThePoint)
{
  for (const std::string name : {"radial", "circumferential", "helical"})
    {
      const auto        field = fibres(name);
      const std::string message =
        input_error([&]() { field->direction(Point<3>(1.5, 0, 0)); });
      EXPECT_TRUE(contains(message, name)) << message;
      EXPECT_TRUE(contains(message, "(1.5, 0, 0)")) << message;
    }

  for (const std::string formulas : {"0; 0; 0*x", "1; log(-x); 0", "1/0; 0; 0"})
    {
      const auto field =
        fibres("vector expression", "set Formulas = " + formulas);
      const std::string message =
        input_error([&]() { field->direction(Point<3>(2, 0.25, 1)); });
      EXPECT_TRUE(
        contains(message, "'Muscles/biceps/vector expression/Formulas'"))
        << message;
      EXPECT_TRUE(contains(message, "(2, 0.25, 1)")) << message;
    }
}



TEST(Fibres, WrongParametersAreErrorsThatNameThem)
{
  EXPECT_TRUE(contains(input_error([]() {
                         fibres("direction", "set Direction = 0, 0, 0");
                       }),
                       "'Direction'"));
  EXPECT_TRUE(contains(input_error([]() {
                         fibres("vector expression", "set Formulas = 1; 2");
                       }),
                       "'Muscles/biceps/vector expression/Formulas'"));
  EXPECT_TRUE(contains(input_error([]() {
                         fibres("vector expression",
                                "set Formulas = 1; 2; foo(x)");
                       }),
                       "'Muscles/biceps/vector expression/Formulas'"));
}
