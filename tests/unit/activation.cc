// SPDX-License-Identifier: LGPL-2.1-or-later
// The activations: closed values, smoothness and travel of the wave.
#include <gtest/gtest.h>

#include <cmath>

#include "activation_in_chain.h"
#include "read_plugin.h"
#include "sample_point.h"

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
