// SPDX-License-Identifier: LGPL-2.1-or-later
// A muscle that pulls: stress, curves and their derivatives, and what is wrong with
// the file of a curve.
#include <lumbricus/action/muscle_action.h>
#include <lumbricus/action/tension_curve.h>
#include <lumbricus/activation/activation.h>
#include <lumbricus/geometry/geometry.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <unistd.h>

#include "read_plugin.h"
#include "sample_point.h"

using namespace lumbricus;
using namespace lumbricus::sample_point;
using dealii::Tensor;

namespace
{
  // A file with a text, for as long as this lives.
  class CurveFile
  {
  public:
    explicit CurveFile(const std::string &text)
    {
      static unsigned int number = 0;
      path = (std::filesystem::temp_directory_path() /
              ("lumbricus_curve_" + std::to_string(::getpid()) + "_" +
               std::to_string(number++) + ".csv"))
               .string();
      std::ofstream(path) << text;
    }

    ~CurveFile()
    {
      std::filesystem::remove(path);
    }

    std::string path;
  };



  template <class Base>
  std::unique_ptr<Base>
  initialized(const std::string &name, const std::string &text)
  {
    auto       object = read_plugin<Base>(name, text);
    const auto bar    = Registry<Geometry>::create("block");
    object->initialize("Muscles/m", *bar);
    return object;
  }



  std::unique_ptr<MuscleAction>
  active_stress(const std::string &settings)
  {
    return initialized<MuscleAction>("active stress",
                                     "set Activation = expression\n"
                                     "subsection active stress\n" +
                                       settings + "end\n");
  }



  const CurveFile rows("l, f_l\n0.4, 0\n0.8, 0.7\n1, 1\n1.3, 0.8\n1.9, 0.1\n");

  const std::vector<std::string> lengths = {
    "",
    "set Force-length = Blemker\nsubsection Blemker\nset Best length = 1.1\nend\n",
    "set Force-length = file\nsubsection file\nset File = " + rows.path +
      "\nset Best length = 0.9\nend\n"};
  const std::vector<std::string> speeds = {
    "", "set Force-velocity = Hill\nsubsection Hill\nset Fastest = 0.7\nend\n"};



  void
  expect_slope(const std::function<CurvePoint(double)> &curve, const double x)
  {
    const double step = 1e-6;
    EXPECT_NEAR(curve(x).slope,
                (curve(x + step).value - curve(x - step).value) / (2. * step),
                1e-7 * (1. + std::abs(curve(x).slope)))
      << x;
  }



  // Where the second derivative jumps.
  void
  expect_no_corner(const std::function<CurvePoint(double)> &curve, const double x)
  {
    EXPECT_NEAR(curve(x - 1e-9).slope, curve(x + 1e-9).slope, 1e-6) << x;
    EXPECT_NEAR(curve(x).slope, curve(x + 1e-9).slope, 1e-6) << x;
    EXPECT_NEAR(curve(x - 1e-9).value, curve(x + 1e-9).value, 1e-7) << x;
  }



  std::string
  error_of(const std::string &text)
  {
    const CurveFile file(text);
    return input_error([&]() {
      initialized<ForceLength>("file", "set File = " + file.path + "\n");
    });
  }
} // namespace



TEST(ActiveStress, StressIsTensionAlongTheFibre)
{
  const Tensor<1, dim> f{{0.6, 0., 0.8}}, a = F_general * f;
  const double         l = a.norm();
  for (const std::string kind : {"nominal", "second Piola"})
    {
      const auto action = active_stress("set Strength = 0.3\nset Kind = " + kind +
                                        "\n");
      MuscleFibre fibre;
      fibre.f               = f;
      fibre.activation      = 0.5;
      fibre.largest_tension = action->largest_tension(0, X);
      EXPECT_EQ(fibre.largest_tension, 0.3);
      MaterialResponse response;
      response.P = 0.;
      action->add_stress(F_general, fibre, false, response);
      const auto expected =
        0.15 * (kind == "nominal" ? 1. / l : 1.) * dealii::outer_product(a, f);
      EXPECT_NEAR((response.P - expected).norm(), 0., 1e-15);
    }
}



TEST(ActiveStress, TangentIsTheDerivative)
{
  for (const std::string kind : {"nominal", "second Piola"})
    for (const std::string &length : lengths)
      for (const std::string &speed : speeds)
        // Long and short, shortening and stretched.
        for (const auto &[scale, before] :
             {std::pair(1., 1.35), std::pair(1., 1.), std::pair(0.7, 0.9),
              std::pair(0.7, 0.7)})
          {
            const auto action = active_stress("set Strength = 0.3\nset Kind = " +
                                              kind + "\n" + length + speed);
            EXPECT_EQ(action->feels_speed(), !speed.empty());
            const MuscleFibre fibre{
              Tensor<1, dim>({0.6, 0., 0.8}), 0.8, 0.3, before, 0.6};
            const auto response = [&](const Tensor<2, dim> &F,
                                      const bool            with_tangent) {
              MaterialResponse all;
              all.P = 0.;
              for (auto &row : all.A)
                for (double &entry : row)
                  entry = 0.;
              action->add_stress(F, fibre, with_tangent, all);
              return all;
            };
            const auto F  = scale * F_general;
            const auto at = response(F, true);
            EXPECT_GT(at.P.norm(), 1e-3);
            for (unsigned int k = 0; k < dim; ++k)
              for (unsigned int L = 0; L < dim; ++L)
                {
                  Tensor<2, dim> step;
                  step[k][L]      = 1e-6;
                  const auto more = response(F + step, false).P,
                             less = response(F - step, false).P;
                  for (unsigned int i = 0; i < dim; ++i)
                    for (unsigned int J = 0; J < dim; ++J)
                      {
                        const double A = at.A[dim * i + J][dim * k + L];
                        EXPECT_NEAR(A, (more - less)[i][J] / 2e-6, 1e-8)
                          << kind << length << speed;
                        EXPECT_NEAR(A, at.A[dim * k + L][dim * i + J], 1e-14);
                      }
                }
          }
}



TEST(ActiveStress, CurvesAreThoseOfTheirSources)
{
  const auto blemker =
    initialized<ForceLength>("Blemker", "set Best length = 2\n");
  for (const auto &[x, f] : {std::pair(0.4, 0.), std::pair(0.5, 0.09),
                             std::pair(0.6, 0.36), std::pair(0.8, 0.84),
                             std::pair(1., 1.), std::pair(1.3, 0.64),
                             std::pair(1.55, 0.0225), std::pair(1.7, 0.),
                             std::pair(0.3, 0.)})
    {
      EXPECT_NEAR(blemker->at(2. * x).value, f, 1e-14) << x;
      if (x != 0.6 && x != 0.4)
        expect_slope([&](const double l) { return blemker->at(l); }, 2. * x);
    }

  const auto hill = initialized<ForceVelocity>(
    "Hill", "set Fastest = 2\nset Curvature = 0.25\nset Largest = 1.6\n");
  EXPECT_EQ(hill->at(0.).value, 1.);
  EXPECT_EQ(hill->at(-2.).value, 0.);
  EXPECT_EQ(hill->at(-5.).value, 0.);
  EXPECT_NEAR(hill->at(1e9).value, 1.6, 1e-6);
  // (T + k T0)(v + k v_max) = (1 + k) T0 k v_max.
  for (const double v : {0.1, 0.7, 1.9})
    EXPECT_NEAR((hill->at(-v).value + 0.25) * (v + 0.5), 1.25 * 0.5, 1e-14);
  const auto at_rate = [&](const double v) { return hill->at(v); };
  for (const double v : {-1.9, -0.3, -0.01, 0.01, 0.4, 3.})
    expect_slope(at_rate, v);
  expect_no_corner(at_rate, 0.);
  EXPECT_FALSE(initialized<ForceVelocity>("none", "")->feels_speed());
}



TEST(ActiveStress, CurveOfAFileIsMonotoneBetweenItsRows)
{
  const auto curve = initialized<ForceLength>("file", "set File = " + rows.path +
                                                        "\n");
  for (const auto &[l, f] : {std::pair(0.4, 0.), std::pair(0.8, 0.7),
                             std::pair(1., 1.), std::pair(1.3, 0.8),
                             std::pair(1.9, 0.1), std::pair(0.2, 0.),
                             std::pair(2.5, 0.1)})
    EXPECT_NEAR(curve->at(l).value, f, 1e-15) << l;
  // From the values and slopes at the rows, in Hermite's form, by hand.
  EXPECT_NEAR(curve->at(0.6).value, 0.365748587571, 1e-11);
  EXPECT_NEAR(curve->at(0.9).value, 0.890042372881, 1e-11);
  EXPECT_NEAR(curve->at(1.6).value, 0.500735294118, 1e-11);
  double last = 0.;
  for (double l = 0.41; l < 1.; l += 0.01)
    {
      EXPECT_GT(curve->at(l).value, last);
      last = curve->at(l).value;
    }
  last = 1.;
  for (double l = 1.01; l < 1.9; l += 0.01)
    {
      EXPECT_LT(curve->at(l).value, last);
      last = curve->at(l).value;
    }
  const auto at_length = [&](const double l) { return curve->at(l); };
  for (const double l : {0.3, 0.5, 0.95, 1.2, 1.7, 2.})
    expect_slope(at_length, l);
  for (const double l : {0.8, 1., 1.3})
    expect_no_corner(at_length, l);
  // Two rows are a line.
  const CurveFile two("l, f_l\n0.5, 0.2\n1.5, 0.6\n");
  const auto      line =
    initialized<ForceLength>("file", "set File = " + two.path + "\n");
  EXPECT_NEAR(line->at(0.75).value, 0.3, 1e-15);
}



TEST(ActiveStress, FaultsOfAFileAreSaidWithTheirLine)
{
  const std::vector<std::pair<std::string, std::string>> faults = {
    {"", "has no rows. Give a line 'l, f_l'"},
    {"l, f_l\n1, 1\n", "has fewer than two rows"},
    {"l\n1\n2\n", "line 1: it has to be 'l, f_l'"},
    {"1, 2\n2, 1\n", "line 1: it has to be 'l, f_l'"},
    {"l, f_l\n1\n", "line 2: it has 1 numbers for 2 columns"},
    {"l, f_l\n1, nan\n", "line 2, column 'f_l': 'nan' is no number"},
    {"l, f_l\n1, x\n", "line 2, column 'f_l': 'x' is no number"},
    {"l, f_l\n1, 1\n# more\n1, 0.5\n", "line 4, column 'l': 1 is not greater"},
    {"l, f_l\n-1, 1\n2, 1\n", "line 2, column 'l': it has to be more than 0"},
    {"l, f_l\n1, 1\n2, -0.1\n", "line 3, column 'f_l': it has to be at least 0"}};
  for (const auto &[text, what] : faults)
    {
      const std::string message = error_of(text);
      EXPECT_TRUE(contains(message, what)) << message;
      EXPECT_TRUE(contains(message, "'Muscles/m/File'")) << message;
    }
  EXPECT_EQ(error_of("l, f_l\n1, 1\n2, 0\n"), "");
}



TEST(ActiveStress, WaveIsOfTheKindOfTheAction)
{
  const std::string wave = "subsection wave\nset Amplitude = 0.6\n"
                           "set Duty = 0.5\nset Ramp-in = 0\nend\n";
  for (const auto &[action, entry, rest, peak] :
       {std::tuple("active stress", "Activation", 0., 0.6),
        std::tuple("active stretch", "Active stretch", 1., 0.4)})
    {
      const auto muscle = initialized<MuscleAction>(
        action, "set " + std::string(entry) + " = wave\n" + wave);
      EXPECT_EQ(muscle->activation()->value(0., 1, X), rest);
      EXPECT_NEAR(muscle->activation()->value(0.25, 1, X), peak, 1e-15);
      EXPECT_EQ(muscle->activation()->value(0.75, 1, X), rest);
    }
}
