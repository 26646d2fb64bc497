// SPDX-License-Identifier: LGPL-2.1-or-later
// The fibre fields: unit length, right angles, and agreement with each other.
#include <lumbricus/fibres/fibre_field.h>
#include <lumbricus/geometry/geometry.h>

#include <deal.II/base/numbers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "../../source/fibres/tensor_fit.h"
#include "read_plugin.h"
#include "temporary_file.h"

using namespace lumbricus;
using dealii::Point;
using dealii::SymmetricTensor;
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



TEST(Fibres, FileGivesTheVectorOfTheNearestOfThreePoints)
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
  for (const std::string part : {"'Muscles/biceps/file/File'", "has 3 points",
                                 "too few to interpolate", "at least four"})
    EXPECT_TRUE(contains(field->warning(), part)) << field->warning();
}



namespace
{
  // A file of the directions of a field at points, of both signs in turn.
  std::string
  samples(const FibreField &field, const std::vector<Point<3>> &at)
  {
    std::ostringstream text;
    text.precision(17);
    double sign = 1.;
    for (const Point<3> &X : at)
      {
        text << X << " " << sign * field.direction(X) << "\n";
        sign = -sign;
      }
    return text.str();
  }



  // Scattered in a cube of unit edge, the same everywhere.
  std::vector<Point<3>>
  scattered(const unsigned int n)
  {
    std::vector<Point<3>> result;
    for (unsigned int i = 1; i <= n; ++i)
      {
        const auto part = [i](const double step) {
          return std::fmod(i * step, 1.);
        };
        result.emplace_back(part(0.8191725134),
                            part(0.6710436067),
                            part(0.5497004779));
      }
    return result;
  }



  // The sine of the largest angle between two fields at points.
  double
  largest_sine(const FibreField            &one,
               const FibreField            &other,
               const std::vector<Point<3>> &at)
  {
    double largest = 0.;
    for (const Point<3> &X : at)
      largest = std::max(largest,
                         cross_product_3d(one.direction(X), other.direction(X))
                           .norm());
    return largest;
  }
} // namespace



TEST(Fibres, FitOfALinearTensorIsExact)
{
  // Points in a block, in a sheet a fiftieth as thick, and in two layers of a tube.
  for (const unsigned int kind : {0, 1, 2})
    {
      const auto tensor_at = [](const Point<3> &X) {
        SymmetricTensor<2, 3> A;
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int j = i; j < 3; ++j)
            A[i][j] = std::sin(1. + 3 * i + j) + std::cos(2. * i + j) * X[0] -
                      std::sin(1. * i - j) * X[1] + (0.3 + i * j) * X[2];
        return A;
      };
      std::vector<TensorSample> samples;
      const Point<3>            X(0.4, 0.6, 0.01);
      for (Point<3> Y : scattered(20))
        {
          if (kind == 1)
            Y[2] /= 50.;
          else if (kind == 2)
            {
              const double r = Y[2] < 0.5 ? 1. : 1.1;
              Y = Point<3>(Y[0], r * std::sin(0.7 * Y[1]), r * std::cos(0.7 * Y[1]));
            }
          samples.push_back({Y - X, tensor_at(Y), 1. / (Y - X).norm_square()});
        }
      const FittedTensor fit = fit_tensor(samples);
      EXPECT_NEAR((fit.A - tensor_at(X)).norm(), 0., 1e-12) << kind;
      EXPECT_NEAR(fit.error, 0., 1e-12) << kind;
    }
}



TEST(Fibres, FileOfOneDirectionHasItEverywhere)
{
  const auto one = fibres("direction", "set Direction = 1, -2, 3");
  for (const unsigned int n : {1, 2, 4, 9, 100})
    {
      const TemporaryFile file(samples(*one, scattered(n)));
      const auto          field =
        fibres("file", "set File = " + file.name + "\nset Reach = 100");
      EXPECT_LT(largest_sine(*one, *field, points), 1e-13);
      EXPECT_LT(largest_sine(*one, *field, scattered(50)), 1e-13);
      for (const Point<3> &X : scattered(200))
        EXPECT_LT(field->error(X), 1e-10);
      if (n > 4)
        {
          EXPECT_EQ(field->warning(), "");
        }
    }
}



TEST(Fibres, FileIsExactAtItsPointsAndSmoothBesideThem)
{
  const auto          helical = fibres("helical", "set Angle = 50");
  const auto          at      = scattered(300);
  const TemporaryFile file(samples(*helical, at));
  const auto          field = fibres("file", "set File = " + file.name);
  EXPECT_LT(largest_sine(*helical, *field, at), 1e-14);
  for (const Point<3> &X : at)
    {
      EXPECT_EQ(field->error(X), 0.);
      const Point<3> beside = X + Point<3>(1e-7, -2e-7, 1e-7);
      EXPECT_LT(
        cross_product_3d(field->direction(X), field->direction(beside)).norm(),
        1e-4);
    }
}



TEST(Fibres, FileAgreesWithHelicalToSecondOrder)
{
  // On the centres of cells of a quarter of a tube, whose surface is half a cell
  // beyond them.
  const auto   helical  = fibres("helical", "set Angle = 30");
  const double pi       = dealii::numbers::PI;
  double       previous = 0.;
  for (const unsigned int n : {8, 16, 32})
    {
      std::vector<Point<3>> centers;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          for (unsigned int k = 0; k < n / 4; ++k)
            {
              const double a = (i + 0.5) / n * pi / 2;
              const double r = 1. + 0.4 * (k + 0.5) / (n / 4);
              centers.emplace_back(1.5 * (j + 0.5) / n,
                                   r * std::cos(a),
                                   r * std::sin(a));
            }
      std::vector<Point<3>> everywhere;
      for (double a = 0.; a < pi / 2 + 1e-6; a += pi / 2 / 47)
        for (double r = 1.; r < 1.41; r += 0.1)
          for (double x = 0.; x <= 1.5; x += 0.5 / 3)
            everywhere.emplace_back(x, r * std::cos(a), r * std::sin(a));
      const TemporaryFile file(samples(*helical, centers));
      const auto          field = fibres("file", "set File = " + file.name);
      EXPECT_EQ(field->warning(), "");
      const double worst = largest_sine(*helical, *field, everywhere);
      double       said = 0.;
      for (const Point<3> &X : everywhere)
        {
          const auto f = helical->direction(X), g = field->direction(X);
          const double off =
            (dealii::outer_product(f, f) - dealii::outer_product(g, g)).norm();
          const double error = field->error(X);
          EXPECT_LE(off, error + 1e-14) << X;
          said = std::max(said, error);
        }
      // What it says of its error is not too much either.
      EXPECT_LT(said, 12. * worst);
      if (previous > 0.)
        {
          EXPECT_LT(worst, previous / 3.3);
          EXPECT_GT(worst, previous / 6.);
        }
      previous = worst;
    }
  EXPECT_LT(previous, 2e-3);
}



TEST(Fibres, FileOfManyThinLayersIsInterpolatedAlongThem)
{
  // The points nearest to one are all on the line through the wall.
  const auto            helical = fibres("helical", "set Angle = 60");
  const double          pi      = dealii::numbers::PI;
  std::vector<Point<3>> layers, everywhere;
  for (unsigned int i = 0; i < 16; ++i)
    for (unsigned int j = 0; j < 12; ++j)
      for (unsigned int k = 0; k < 60; ++k)
        {
          const double a = (i + 0.5) / 16 * pi / 2, r = 1. + 0.1 * (k + 0.5) / 60;
          layers.emplace_back((j + 0.5) / 12, r * std::cos(a), r * std::sin(a));
        }
  for (double a = 0.; a < pi / 2 + 1e-6; a += pi / 2 / 47)
    for (const double r : {1., 1.03, 1.1})
      for (const double x : {0.2, 0.5, 0.61})
        everywhere.emplace_back(x, r * std::cos(a), r * std::sin(a));
  const TemporaryFile file(samples(*helical, layers));
  const auto          field =
    fibres("file", "set File = " + file.name + "\nset Reach = 0.1");
  const double worst = largest_sine(*helical, *field, everywhere);
  EXPECT_LT(worst, 0.005);
  for (const Point<3> &X : everywhere)
    {
      const auto f = helical->direction(X), g = field->direction(X);
      EXPECT_LE(
        (dealii::outer_product(f, f) - dealii::outer_product(g, g)).norm(),
        field->error(X));
    }
}



TEST(Fibres, FileOfASurfaceSaysNothingOfTheDepth)
{
  // The points of one layer are apart across it only as far as it is curved, and
  // fibres beside it are as those in it.
  const auto   helical  = fibres("helical", "set Angle = 30");
  double       previous = 0.;
  for (const unsigned int n : {8, 16, 32})
    {
      std::vector<Point<3>> layer, beside;
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          {
            const double a = (i + 0.5) / n * dealii::numbers::PI / 2;
            layer.emplace_back((j + 0.5) / n, std::cos(a), std::sin(a));
          }
      for (double a = 0.; a < 1.57; a += 0.03)
        for (const double r : {1. - 0.7 / n, 1., 1. + 0.7 / n})
          beside.emplace_back(0.37, r * std::cos(a), r * std::sin(a));
      const TemporaryFile file(samples(*helical, layer));
      const auto          field = fibres("file", "set File = " + file.name);
      const double        worst = largest_sine(*helical, *field, beside);
      EXPECT_LT(worst, 1.5 / n / n);
      if (previous > 0.)
        {
          EXPECT_LT(worst, previous / 3.);
        }
      previous = worst;
    }
}



TEST(Fibres, FileWithDirectionsThatContradictWarns)
{
  std::string text;
  for (unsigned int i = 0; i < 4; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      for (unsigned int k = 0; k < 3; ++k)
        text += std::to_string(i) + " " + std::to_string(j) + " " +
                std::to_string(k) + (i < 2 ? " 1 0 0\n" : " 0 1 0\n");
  const TemporaryFile file(text);
  const auto          field = fibres("file", "set File = " + file.name);
  for (const std::string part :
       {"90 degrees apart", "in lines", "a file for each of two muscles"})
    EXPECT_TRUE(contains(field->warning(), part)) << field->warning();
  // In the middle there is no mean.
  const Point<3> X(1.4999999, 1, 1);
  expect_equal(field->direction(X), Point<3>(1, 0, 0));
  EXPECT_EQ(field->error(X), 1.);

  std::string flat;
  for (unsigned int i = 0; i < 4; ++i)
    for (unsigned int j = 0; j < 4; ++j)
      flat +=
        std::to_string(i) + " " + std::to_string(j) + " 0 " +
        std::to_string(10 + i) + " 1 0\n";
  const TemporaryFile plane(flat);
  const auto          in_plane = fibres("file", "set File = " + plane.name);
  EXPECT_TRUE(contains(in_plane->warning(), "all points in a plane"))
    << in_plane->warning();
  EXPECT_LT((in_plane->direction(Point<3>(1.3, 1.6, 0.9)) -
             in_plane->direction(Point<3>(1.3, 1.6, 0.)))
              .norm(),
            1e-3);
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
