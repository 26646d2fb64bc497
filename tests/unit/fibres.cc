// SPDX-License-Identifier: LGPL-2.1-or-later
// The fibre fields: unit length, right angles, and agreement with each other.
#include <lumbricus/fibres/fibre_field.h>
#include <lumbricus/geometry/geometry.h>

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "read_plugin.h"
#include "temporary_file.h"

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
    result->initialize("Muscles/biceps/" + name,
                       *Registry<Geometry>::create("block"));
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
                       "'Formulas'"));
  EXPECT_TRUE(contains(input_error([]() {
                         fibres("vector expression",
                                "set Formulas = 1; 2; foo(x)");
                       }),
                       "'Formulas'"));
}



TEST(Fibres, FileGivesTheVectorOfTheNearestPoint)
{
  const TemporaryFile file("# A comment, and a line of names.\n"
                       "x, y, z, fx, fy, fz\n"
                       "\n"
                       "0, 0, 0, 2, 0, 0\n"
                       "1 0 0   0 3e0 -4 # blanks\n"
                       "0\t1\t0;0\t0\t-1\r\n");
  const auto      field = fibres("file", "set File = " + file.name);
  expect_equal(field->direction(Point<3>(0.1, 0.2, 0.3)), Point<3>(1, 0, 0));
  expect_equal(field->direction(Point<3>(0.6, 0.4, 0)), Point<3>(0, 0.6, -0.8));
  expect_equal(field->direction(Point<3>(-1, 1.4, 0)), Point<3>(0, 0, -1));
}



TEST(Fibres, FileAgreesWithHelicalTheFinerTheNearer)
{
  const auto helical  = fibres("helical", "set Angle = 30");
  double     previous = 1.;
  for (const unsigned int n : {8, 32})
    {
      std::ostringstream text;
      text.precision(16);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          {
            const double   a = (i + 0.5) / n * dealii::numbers::PI / 2;
            const Point<3> X((j + 0.5) / n, std::cos(a), std::sin(a));
            text << X << " " << 7. * helical->direction(X) << "\n";
          }
      const TemporaryFile file(text.str());
      const auto      field = fibres("file", "set File = " + file.name);
      double          worst = 0.;
      for (double a = 0.01; a < 1.57; a += 0.01)
        for (double x = 0.; x <= 1.; x += 0.1)
          {
            const Point<3> X(x, 1.1 * std::cos(a), 1.1 * std::sin(a));
            worst =
              std::max(worst,
                       (field->direction(X) - helical->direction(X)).norm());
          }
      // Half a cell away: an angle of pi/4/n.
      EXPECT_LT(worst, 0.8 / n);
      EXPECT_LT(worst, 0.5 * previous);
      previous = worst;
    }
}



TEST(Fibres, FileThatLacksAPartIsAnErrorThatNamesThePoint)
{
  std::string text;
  for (unsigned int i = 0; i < 10; ++i)
    text += std::to_string(i) + " 0 0 1 0 0\n";
  const TemporaryFile   file(text);
  const std::string far_away = input_error([&]() {
    fibres("file", "set File = " + file.name)->direction(Point<3>(4, 0, 25));
  });
  for (const std::string part : {"'Muscles/biceps/file/File'",
                                 "(4, 0, 25)",
                                 "(4, 0, 0) in line 5",
                                 "25 mm away",
                                 "'Muscles/biceps/file/Reach'"})
    EXPECT_TRUE(contains(far_away, part)) << far_away;
  const auto within_reach =
    fibres("file", "set File = " + file.name + "\nset Reach = 26");
  expect_equal(within_reach->direction(Point<3>(4, 0, 25)), Point<3>(1, 0, 0));
}



TEST(Fibres, WrongLinesOfAFileAreErrorsThatNameThem)
{
  const auto expect = [](const std::string &text,
                         const std::string &part,
                         const std::string &other_part) {
    const TemporaryFile   file(text);
    const std::string message =
      input_error([&]() { fibres("file", "set File = " + file.name); });
    EXPECT_TRUE(contains(message, "'Muscles/biceps/file/File'")) << message;
    EXPECT_TRUE(contains(message, part)) << message;
    EXPECT_TRUE(contains(message, other_part)) << message;
  };
  const std::string good = "0 0 0 1 0 0\n";
  expect(good + "1 0 0 1 0\n", "line 2", "5 entries");
  expect(good + "\n1 0 0 1 0 0 1\n", "line 3", "7 entries");
  expect(good + "1 0 0 1 O 0\n", "line 2", "'O'");
  expect(good + "1 0 0 nan 0 0\n", "line 2", "'nan'");
  expect(good + "1 0 0 0 0 0\n", "line 2", "length zero");
  expect(good + "x y z fx fy fz\n", "line 2", "'x'");
  expect("a, b, c, d, e, f\n" + good, "line 1", "'a'");
  expect("# nothing\n", "has no points", "x, y, z, fx, fy, fz");
  expect(good + "0 0 1 1 0 0\n0 0 0 0 1 0\n", "lines 1 and 3", "same point");
  EXPECT_TRUE(contains(input_error([]() {
                         fibres("file", "set File = there_is_none.csv");
                       }),
                       "'there_is_none.csv' cannot be read"));
  EXPECT_TRUE(contains(input_error([]() { fibres("file"); }),
                       "'Muscles/biceps/file/File' is not set"));
}



TEST(Fibres, EllipsoidalTurnWithTheDepth)
{
  const auto ventricle = Registry<Geometry>::create("truncated ellipsoid");
  const auto field     = read_plugin<FibreField>("ellipsoidal");
  field->initialize("Muscles/heart/ellipsoidal", *ventricle);
  for (const double t : {0., 0.25, 0.5, 1.})
    for (const double theta : {0.1, 1.1, 1.8})
      {
        const double  s = 7 + 3 * t, l = 17 + 3 * t;
        const Point<3> X(-l * std::cos(theta), 0., s * std::sin(theta));
        // Along the meridian towards the base, and around the axis.
        Tensor<1, 3> up, around;
        up[0]     = l * std::sin(theta);
        up[2]     = s * std::cos(theta);
        around[1] = -1.;
        const double a = (90 - 180 * t) * dealii::numbers::PI / 180;
        EXPECT_NEAR((field->direction(X) - std::sin(a) * up / up.norm() -
                     std::cos(a) * around)
                      .norm(),
                    0.,
                    1e-12);
      }
  EXPECT_TRUE(contains(input_error([&]() { field->direction({-17., 0., 0.}); }),
                       "-17"));
  EXPECT_TRUE(contains(input_error([]() { fibres("ellipsoidal"); }),
                       "'truncated ellipsoid'"));
}
