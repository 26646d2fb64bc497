// SPDX-License-Identifier: LGPL-2.1-or-later
// The activations: closed values, smoothness and travel of the wave, tables.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

#include "activation_in_chain.h"
#include "read_plugin.h"
#include "sample_point.h"
#include "temporary_file.h"

using namespace lumbricus;
using lumbricus::sample_point::X;
using dealii::Point;

namespace
{
  // Amplitude 0.3, wavelength 5, period 2, duty 0.4.
  const std::string wave_text = "set Amplitude = 0.3\n"
                                "set Wavelength = 5\n"
                                "set Period = 2\n"
                                "set Duty = 0.4\n";
} // namespace



TEST(Activation, WaveHasClosedValues)
{
  const auto wave = activation("wave", wave_text + "set Ramp-in = 0");
  // The pulse lasts from 0 to 0.8, and is at its peak in the middle.
  EXPECT_NEAR(wave->value(0., 1, X), 1., 1e-14);
  EXPECT_NEAR(wave->value(0.2, 1, X), 1. - 0.3 / 2, 1e-14);
  EXPECT_NEAR(wave->value(0.4, 1, X), 1. - 0.3, 1e-14);
  EXPECT_NEAR(wave->value(0.8, 1, X), 1., 1e-14);
  EXPECT_EQ(wave->value(1.3, 1, X), 1.);

  const auto longer =
    activation("wave", "set Amplitude = -0.5\nset Ramp-in = 0\nset Duty = 1");
  EXPECT_NEAR(longer->value(0.5, 1, X), 1.5, 1e-14);

  const auto ahead =
    activation("wave", wave_text + "set Ramp-in = 0\nset Phase = 0.2");
  EXPECT_NEAR(ahead->value(0., 1, X), 1. - 0.3, 1e-14);
}



TEST(Activation, WaveHasFormulasInTheSegment)
{
  // Ten segments: two waves on the body, weaker towards the tail.
  const auto wave = activation("wave",
                               "set Ramp-in = 0\nset Duty = 1\n"
                               "set Amplitude = 0.5*(n + 1 - s)/n\n"
                               "set Wavelength = n/2\n");
  EXPECT_NEAR(wave->value(0.5, 1, X), 0.5, 1e-14);
  EXPECT_NEAR(wave->value(0.5, 6, X), 0.75, 1e-14);
  EXPECT_NEAR(wave->value(0.7, 2, X), 1. - 0.45, 1e-14);
}



TEST(Activation, WaveTravelsOneSegmentInPeriodByWavelength)
{
  const double delay   = 2. / 5;
  const auto   to_tail = activation("wave", wave_text + "set Ramp-in = 0");
  const auto   to_head =
    activation("wave",
               wave_text + "set Ramp-in = 0\nset Direction = towards head");
  for (double t = 0.05; t < 2.; t += 0.11)
    for (unsigned int s = 1; s < 10; ++s)
      {
        EXPECT_NEAR(to_tail->value(t, s, X),
                    to_tail->value(t + delay, s + 1, X),
                    1e-12);
        EXPECT_NEAR(to_head->value(t, s + 1, X),
                    to_head->value(t + delay, s, X),
                    1e-12);
      }
  // Five segments further is one wavelength.
  EXPECT_NEAR(to_tail->value(0.3, 1, X), to_tail->value(0.3, 6, X), 1e-12);
}



TEST(Activation, WaveIsPeriodicAfterTheRamp)
{
  const auto wave = activation("wave", wave_text + "set Ramp-in = 3");
  for (double t = 3.; t < 5.; t += 0.13)
    EXPECT_NEAR(wave->value(t, 3, X), wave->value(t + 2, 3, X), 1e-12);
}



TEST(Activation, RampStartsFromRestAndEndsAtTheFullWave)
{
  const auto ramped = activation("wave", wave_text + "set Ramp-in = 3");
  const auto full   = activation("wave", wave_text + "set Ramp-in = 0");
  for (unsigned int s = 1; s <= 10; ++s)
    {
      EXPECT_EQ(ramped->value(0., s, X), 1.);
      EXPECT_NEAR(ramped->value(3.1, s, X), full->value(3.1, s, X), 1e-14);
      // Halfway, half of it.
      EXPECT_NEAR(ramped->value(1.5, s, X) - 1.,
                  (full->value(1.5, s, X) - 1.) / 2,
                  1e-14);
    }
}



TEST(Activation, WaveIsContinuouslyDifferentiable)
{
  // The difference of neighbouring difference quotients is bounded by the
  // second derivative, 0.3 * 2 pi^2/(0.8)^2 = 9.3, and the ramp.
  const double h = 1e-4;
  for (const std::string ramp : {"0", "1.7"})
    {
      const auto wave = activation("wave", wave_text + "set Ramp-in = " + ramp);
      for (double t = 0.01; t < 4.5; t += h)
        {
          const double a = wave->value(t - h, 2, X);
          const double b = wave->value(t, 2, X);
          const double c = wave->value(t + h, 2, X);
          ASSERT_LT(std::abs((c - b) - (b - a)) / h, 20 * h) << "t = " << t;
        }
    }
}



TEST(Activation, ExpressionKnowsTimeSegmentAndPosition)
{
  const auto formula =
    activation("expression", "set Formula = 1 - 0.1*t*s/n + x + 10*y + 100*z");
  EXPECT_NEAR(formula->value(2., 3, X), 1 - 0.06 + 0.1 + 2 + 30, 1e-13);
  EXPECT_NEAR(formula->value(1., 10, Point<3>()), 0.9, 1e-14);
  EXPECT_NEAR(
    activation("expression", "set Formula = cos(pi*t)")->value(1., 1, X),
    -1.,
    1e-14);
}



TEST(Activation, WrongParametersAreErrorsThatNameThem)
{
  EXPECT_TRUE(contains(input_error([]() {
                         activation("expression", "set Formula = 1 + q");
                       }),
                       "'Formula'"));
  EXPECT_TRUE(
    contains(input_error([]() { activation("wave", "set Amplitude = s/10"); }),
             "is 1 for segment 10"));
  EXPECT_TRUE(
    contains(input_error([]() { activation("wave", "set Wavelength = s - 4"); }),
             "'Muscles/longitudinal/wave/Wavelength' is -3 for segment 1"));
  EXPECT_TRUE(
    contains(input_error([]() { activation("wave", "set Amplitude = 0.1*t"); }),
             "Use s and n"));
  EXPECT_TRUE(
    contains(input_error([]() { activation("wave", "set Amplitude = 1"); }),
             "wave/Amplitude' is 1 for segment 1"));
  EXPECT_TRUE(
    contains(input_error([]() { activation("wave", "set Duty = 1.01"); }),
             "'Duty'"));
}



namespace
{
  // The table with this text, with more parameters.
  std::unique_ptr<Activation>
  table(const std::string &text,
        const std::string &more       = "",
        const unsigned int n_segments = 2)
  {
    const TemporaryFile file(text);
    return activation("table",
                      "set File = " + file.name + "\n" + more,
                      n_segments);
  }
} // namespace



TEST(Activation, TableIsLinearBetweenItsRows)
{
  const auto of = table("t, 2, 1\n0, 1, 1\n0.5, 0.8, 0.9 # a comment\n\n"
                        "2, 0.5, 1\n");
  EXPECT_EQ(of->value(0., 1, X), 1.);
  EXPECT_NEAR(of->value(0.25, 1, X), 0.95, 1e-15);
  EXPECT_NEAR(of->value(0.25, 2, X), 0.9, 1e-15);
  EXPECT_EQ(of->value(0.5, 2, X), 0.8);
  EXPECT_NEAR(of->value(1.25, 2, X), 0.65, 1e-15);
  EXPECT_EQ(of->value(2., 2, X), 0.5);
  const auto all = table("t, all\n0, 1\n1, 0.5\n");
  for (const unsigned int s : {1, 2})
    EXPECT_NEAR(all->value(0.5, s, X), 0.75, 1e-15);
}



TEST(Activation, TableHasStepsThatBeginWithARow)
{
  const auto of =
    table("t, all\n0, 1\n0.5, 0.8\n2, 0.5\n", "set Between rows = steps\n");
  for (const auto &[t, d] : std::vector<std::pair<double, double>>{
         {0., 1.}, {0.4999, 1.}, {0.5, 0.8}, {1.9999, 0.8}, {2., 0.5}})
    EXPECT_EQ(of->value(t, 1, X), d) << t;
}



// Inside of a table, numbers of boost::math::interpolators::pchip.
TEST(Activation, TableIsMonotoneWhereItIsCubic)
{
  const std::string rows = "t, all\n0, 1\n0.5, 0.9\n1, 0.6\n2, 0.5\n3, 0.8\n"
                           "4, 0.8\n5, 0.7\n";
  const auto of = table(rows, "set Between rows = cubic\n");
  for (const auto &[t, d] :
       std::vector<std::pair<double, double>>{
         {0.6, 0.8525793103448277},
         {0.75, 0.7428879310344827},
         {1.3, 0.55102758620689651},
         {1.9, 0.5011241379310345},
         {2.25, 0.546875},
         {2.5, 0.65000000000000002},
         {3.7, 0.80000000000000004}})
    EXPECT_NEAR(of->value(t, 1, X), d, 1e-14) << t;
  // Never beyond its rows, and without corners.
  constexpr double h = 1e-6;
  for (double t = 0.01; t < 4.99; t += 0.01)
    {
      EXPECT_LE(of->value(t, 1, X), 1.);
      EXPECT_GE(of->value(t, 1, X), 0.5);
      EXPECT_NEAR(of->value(t + h, 1, X) - of->value(t, 1, X),
                  of->value(t, 1, X) - of->value(t - h, 1, X),
                  1e-10)
        << t;
    }
}



TEST(Activation, TableRepeats)
{
  for (const std::string kind : {"linear", "cubic", "steps"})
    {
      // With its first row once more at the end, and without.
      const std::string rows = "t, all\n0.5, 1\n1, 0.8\n2, 0.6\n";
      const std::string more = "set Between rows = " + kind + "\nset Repeat = ";
      const auto        open = table(rows, more + "2.5\n");
      const auto        same = table(rows + "3, 1\n", more + "2.5\n");
      // Not at the steps, where rounding decides.
      for (double t = 0.013; t < 2.5; t += 0.05)
        {
          EXPECT_NEAR(open->value(t, 1, X), open->value(t + 25., 1, X), 1e-13);
          EXPECT_NEAR(open->value(t, 1, X), same->value(t, 1, X), 1e-13)
            << kind << t;
        }
      EXPECT_EQ(open->value(3., 1, X), 1.);
    }
  // What begins anew may jump.
  const auto saw = table("t, all\n0, 1\n1, 0.5\n",
                         "set Repeat = 1\nset Between rows = cubic");
  EXPECT_NEAR(saw->value(4. - 1e-9, 1, X), 0.5, 1e-8);
  EXPECT_EQ(saw->value(4., 1, X), 1.);
  EXPECT_NEAR(saw->value(4.5, 1, X), 0.75, 1e-14);
}



TEST(Activation, TableHasItsRowsAsMarks)
{
  const std::string rows = "t, all\n0, 1\n0.4, 0.9\n0.5, 0.5\n0.6, 1\n";
  EXPECT_EQ(table(rows)->marks(1, 0., 0.55), (std::vector<double>{0.4, 0.5}));
  const auto twice = table(rows, "set Repeat = 1")->marks(1, 0.45, 1.45);
  const std::vector<double> marks = {0.5, 0.6, 1., 1.4};
  ASSERT_EQ(twice.size(), marks.size());
  for (unsigned int i = 0; i < marks.size(); ++i)
    EXPECT_NEAR(twice[i], marks[i], 1e-14);

  // One row of very many.
  std::ostringstream text;
  for (unsigned int i = 0; i <= 100000; ++i)
    text << (i == 0 ? "t, all\n" : "") << i * 1e-5 << ", "
         << (i == 43210 ? 0.5 : 1.) << "\n";
  const auto many = table(text.str())->marks(1, 0., 1.);
  EXPECT_LE(many.size(), 200u);
  EXPECT_TRUE(std::any_of(many.begin(), many.end(), [](const double t) {
    return std::abs(t - 0.43210) < 1e-12;
  }));
}



TEST(Activation, WrongTablesAreErrorsThatNameLineAndColumn)
{
  for (const auto &[text, parts] :
       std::vector<std::pair<std::string, std::vector<std::string>>>{
         {"", {"has no rows"}},
         {"t, 1, 2\n", {"has no rows"}},
         {"time, 1, 2\n0, 1, 1\n", {"line 1", "'time'", "'t'"}},
         {"t\n0\n", {"line 1", "'1' is missing", "'t, all'"}},
         {"t, 1\n0, 1\n", {"line 1", "'2' is missing", "2 segments"}},
         {"t, 1, 2, 3\n0, 1, 1, 1\n", {"line 1", "'3'", "2 segments"}},
         {"t, 1, 1\n0, 1, 1\n", {"line 1", "'1' is there twice"}},
         {"t, all, 1\n0, 1, 1\n", {"line 1", "'2' is missing"}},
         {"t, 1, 2\n0, 1, 1\n0.1, 1\n", {"line 3", "2 numbers", "3 columns"}},
         {"t, 1, 2\n0, 1, 1\n0.1, , 1\n", {"line 3", "column '1'", "nothing"}},
         {"t, 1, 2\n0, 1,\n", {"line 2", "column '2'", "nothing"}},
         {"t, 1, 2\n0, 1, nan\n", {"line 2", "column '2'", "'nan'"}},
         {"t, 1, 2\n0, inf, 1\n", {"line 2", "column '1'", "'inf'"}},
         {"t, all\n0, 1e999\n", {"line 2", "column 'all'", "'1e999'"}},
         {"t, all\n0, 1\n1, 1\n0.5, 1\n", {"line 4", "'t'", "0.5"}},
         {"t, all\n0, 1\n1, 1\n\n1, 1\n", {"line 5", "'t'", "increase"}}})
    {
      const std::string message = input_error([&t = text]() { table(t); });
      EXPECT_TRUE(contains(message, "'Muscles/longitudinal/table/File'"))
        << message;
      for (const std::string &part : parts)
        EXPECT_TRUE(contains(message, part)) << text << message;
    }
  const std::string good = "t, all\n0, 1\n1, 0.8\n";
  EXPECT_TRUE(contains(input_error([&]() { table(good, "set Repeat = 0.5"); }),
                       "'Muscles/longitudinal/table/Repeat'"));
  for (const double t : {-0.1, 1.1})
    EXPECT_TRUE(contains(input_error([&]() { table(good)->value(t, 1, X); }),
                         "is from t = 0 to 1"));
  EXPECT_TRUE(contains(input_error([]() { activation("table", ""); }),
                       "'Muscles/longitudinal/table/File' is not set"));
  EXPECT_TRUE(contains(input_error([]() {
                         activation("table", "set File = nowhere.csv");
                       }),
                       "'nowhere.csv' cannot be read: No such file"));
  EXPECT_TRUE(contains(input_error([&]() {
                         table(good)->check_given([](const double d) {
                           return d < 0.9 ? "at least 0.9" : "";
                         });
                       }),
                       "line 3, column 'all': it is 0.8, but has to be at "
                       "least 0.9"));
}
