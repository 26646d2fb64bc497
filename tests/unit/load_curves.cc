// SPDX-License-Identifier: LGPL-2.1-or-later
// Load steps see the loads at their ends only. A muscle that twitched for a time
// shorter than a step was stepped over in silence, and where an active stretch
// jumped "take a smaller step" could not help. What steps must not miss, where a
// datum jumps, and the data on the way over a jump.
#include <lumbricus/continuation/load_curves.h>
#include <lumbricus/continuation/load_stepping.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>

#include <gtest/gtest.h>

#include <cmath>

#include "activation_in_chain.h"
#include "sample_point.h"
#include "specimen.h"

using namespace lumbricus;
using lumbricus::sample_point::X;
using dealii::numbers::PI;

namespace
{
  using Value = std::function<double(double)>;

  LoadCurve
  curve(const Value &value, const double at_rest = 0.)
  {
    LoadCurve curve;
    curve.what    = "the load";
    curve.at_rest = at_rest;
    curve.values  = {value};
    return curve;
  }

  LoadCurves
  follow(const std::vector<LoadCurve> &curves, const double end = 4.)
  {
    LoadCurves all;
    all.follow(curves, end, 1e-4);
    return all;
  }

  // The curves of a wave in all its segments.
  std::vector<LoadCurve>
  wave_curves(const std::string &text, const unsigned int n_segments)
  {
    const std::shared_ptr<Activation> wave = activation("wave", text, n_segments);
    std::vector<LoadCurve> curves;
    for (unsigned int s = 1; s <= n_segments; ++s)
      {
        curves.push_back(
          curve([=](const double t) { return wave->value(t, s, X); }, 1.));
        curves.back().marks = [=](const double from, const double to) {
          return wave->marks(s, from, to);
        };
      }
    return curves;
  }

  // The ends of the steps of a run that are wanted to be as long as this.
  std::vector<double>
  steps(const LoadCurves &curves, const double end, const double size)
  {
    std::vector<double> times = {0.};
    while (times.back() < end * (1. - 1e-12) && times.size() < 100000)
      {
        const double planned = times.back() + size * (1. + 1e-6) >= end ?
                                 end :
                                 times.back() + size;
        times.push_back(curves.divide(times.back(), planned).to);
        EXPECT_GT(times.back(), times[times.size() - 2]);
      }
    return times;
  }

  bool
  has(const std::vector<double> &times, const double t, const double tolerance)
  {
    for (const double at : times)
      if (std::abs(at - t) <= tolerance)
        return true;
    return false;
  }

  // How far a function goes beyond its values at the ends of steps.
  double
  largest_excess(const Value &value, const std::vector<double> &times)
  {
    double excess = 0.;
    for (std::size_t i = 1; i < times.size(); ++i)
      {
        const auto [least, greatest] =
          std::minmax({value(times[i - 1]), value(times[i])});
        constexpr unsigned int n = 5000;
        for (unsigned int k = 0; k <= n; ++k)
          {
            const double d =
              value(times[i - 1] + k * (times[i] - times[i - 1]) / n);
            excess = std::max({excess, d - greatest, least - d});
          }
      }
    return excess;
  }
} // namespace



TEST(LoadTime, GoesFromOneTimeToAnother)
{
  const Value d = [](const double t) { return 3. + std::sin(t); };
  EXPECT_EQ(LoadTime(0.7).take(d, 1.), d(0.7));
  EXPECT_EQ(LoadTime::between(0.2, 0.7, 1.).take(d, 1.), d(0.7));
  EXPECT_NEAR(LoadTime::between(0.2, 0.7, 0.25).take(d, 1.),
              0.75 * d(0.2) + 0.25 * d(0.7),
              1e-15);
  EXPECT_NEAR(LoadTime::between({}, 0.7, 0.25).take(d, 1.),
              0.75 + 0.25 * d(0.7),
              1e-15);
}



TEST(Marks, OfAWave)
{
  const auto wave = activation("wave",
                                            "set Amplitude = 0.3\n"
                                            "set Wavelength = 5\n"
                                            "set Period = 2\n"
                                            "set Duty = 0.1\n"
                                            "set Phase = 0.25\n"
                                            "set Ramp-in = 0");
  // Segment 3 is 2/5 of a period behind segment 1, which is a quarter ahead.
  const double begin = 2. * (0.4 - 0.25);
  const auto   marks = wave->marks(3, 0., 4.);
  ASSERT_EQ(marks.size(), 6u);
  for (unsigned int i = 0; i < 6; ++i)
    {
      EXPECT_NEAR(marks[i], begin + 2 * (i / 3) + 0.1 * (i % 3), 1e-14);
      EXPECT_NEAR(wave->value(marks[i], 3, X), i % 3 == 1 ? 0.7 : 1., 1e-12);
    }
  // Without the ends, and not more than anybody can step on.
  EXPECT_EQ(wave->marks(3, marks[0], marks[2]).size(), 1u);
  EXPECT_LE(wave->marks(3, 0., 1e9).size(), 300u);

  const auto to_head = activation(
    "wave", "set Direction = towards head\nset Ramp-in = 0\nset Duty = 0.2");
  EXPECT_NEAR(to_head->marks(3, 0., 1.)[0], 0.5, 1e-14);
  EXPECT_NEAR(to_head->marks(3, 0., 1.)[1], 0.6, 1e-14);
}



TEST(Steps, EndWhereShortPulsesBeginPeakAndEnd)
{
  // Pulses of this part of a step, down to a thousandth of what samples see.
  for (const double duty : {0.04, 0.01, 1e-3, 1e-7})
    for (const double size : {0.05, 0.03})
      {
        const std::string text = "set Amplitude = 0.4\nset Ramp-in = 0\n"
                                 "set Duty = " +
                                 dealii::Utilities::to_string(duty);
        const auto times = steps(follow(wave_curves(text, 1)), 4., size);
        for (unsigned int beat = 0; beat < 4; ++beat)
          for (const double part : {0., 0.5, 1.})
            EXPECT_TRUE(has(times, beat + part * duty, 1e-12))
              << duty << ' ' << size << ' ' << beat << ' ' << part;
        EXPECT_LE(times.size(), 4 / size + 4 * 5);
      }
}



TEST(Steps, StayWhatTheyAreWithPulsesOfFourStepsAndMore)
{
  for (const double duty : {0.2, 0.25, 0.5, 1.})
    {
      const std::string text = "set Amplitude = 0.25\nset Wavelength = 7\n"
                               "set Duty = " +
                               dealii::Utilities::to_string(duty);
      for (const double end : {0.25, 1., 4.})
        EXPECT_EQ(steps(follow(wave_curves(text, 10), end), end, 0.05),
                  steps(follow({}, end), end, 0.05))
          << duty;
    }
  // And with what only grows, however unevenly, or does nothing.
  for (const Value &d :
       {Value([](const double t) { return std::pow(t, 5); }),
        Value([](const double t) { return t < 2.013 ? 1. : 0.; }),
        Value([](const double t) { return std::tanh(1e3 * (t - 1.01)); }),
        Value([](const double /*t*/) { return 0.1; })})
    EXPECT_EQ(steps(follow({curve(d)}), 4., 0.05), steps(follow({}), 4., 0.05));
}



TEST(Steps, MeetThePeaksOfFormulas)
{
  const Value pulses = [](const double t) {
    return 1 - 0.4 * std::exp(-std::pow((t - std::floor(t) - 0.475) / 0.004, 2));
  };
  const auto times = steps(follow({curve(pulses)}), 4., 0.05);
  for (unsigned int beat = 0; beat < 4; ++beat)
    EXPECT_TRUE(has(times, beat + 0.475, 1e-8));
  EXPECT_LE(times.size(), 4 / 0.05 + 4 * 5);

  // A pulse that is there at once and gone at once: right before and after.
  const Value box = [](const double t) {
    return t >= 0.47 && t < 0.48 ? 0.6 : 1.;
  };
  const auto of_box = steps(follow({curve(box)}), 4., 0.05);
  for (const double t : {0.47 - 4e-9, 0.47, 0.48 - 4e-9, 0.48})
    EXPECT_TRUE(has(of_box, t, 1e-12)) << t;
  EXPECT_LE(of_box.size(), 90u);
}



// What is promised, for pulses of many kinds that come at any time.
TEST(Steps, MissLessThanThePromisedPart)
{
  const std::vector<Value> many = {
    [](const double t) { return std::sin(200. * t); },
    [](const double t) { return t + 0.3 * std::pow(std::sin(37. * t), 40); },
    [](const double t) { return t - std::floor(3. * t) / 3; },
    [](const double t) { return std::fmod(t, 0.3) < 0.01 ? t : 0.; },
    [](const double t) { return std::max(0., std::cos(23. * t) - 0.97); },
    [](const double t) { return std::exp(-std::pow((t - 1.33) / 1e-3, 2)); }};
  for (unsigned int i = 0; i < many.size(); ++i)
    {
      Value  d     = many[i];
      double least = d(0.), greatest = least;
      for (double t = 0.; t <= 4.; t += 1e-4)
        {
          least    = std::min(least, d(t));
          greatest = std::max(greatest, d(t));
        }
      const auto times = steps(follow({curve(d)}), 4., 0.05);
      EXPECT_LE(largest_excess(d, times), 0.1501 * (greatest - least)) << i;
      EXPECT_LE(times.size(), 1500u) << i;
    }
}



// A pulse as short as a step in each of 150 segments, at any time: 450 marks a
// period, most of them next to others.
TEST(Steps, AreNotManyWithManyMarks)
{
  const std::string text = "set Wavelength = 150\nset Ramp-in = 0\n"
                           "set Duty = 0.05";
  const auto curves = wave_curves(text, 150);
  const auto times  = steps(follow(curves, 1.), 1., 0.05);
  EXPECT_LE(times.size(), 120u);
  for (unsigned int s = 0; s < 150; s += 13)
    EXPECT_LE(largest_excess(curves[s].values[0], times), 0.1501 * 0.2);
}



TEST(Jumps, AreFoundToTheLastBit)
{
  const auto all = follow(
    {curve([](const double t) { return 1. + 0.1 * t; }),
     curve([](const double t) { return t < 0.5 ? 1. : 0.5 + 0.01 * t; }, 1.)});
  const auto jump = all.jump(0.4, 0.55);
  ASSERT_TRUE(jump);
  EXPECT_EQ(jump->after, 0.5);
  EXPECT_NEAR(*jump->before, 0.5 - 4e-9, 1e-15);
  EXPECT_EQ(jump->from, 1.);
  EXPECT_NEAR(jump->to, 0.505, 1e-14);
  EXPECT_EQ(jump->curve->at_rest, 1.);
  EXPECT_TRUE(contains(jump_text(*jump),
                       "the load jumps between the times 0.499999996 and 0.5, "
                       "from 1 to 0.505"));
  EXPECT_FALSE(all.jump(0.4, 0.49));
  // From right before it, it is the same one.
  EXPECT_EQ(*all.jump(*jump->before, 0.5)->before, *jump->before);
}



TEST(Jumps, AreWhatSmallerStepsDoNotDivide)
{
  LoadCurves all;
  const auto found = [&](const Value &d, const double from, const double to) {
    all = follow({curve(d)});
    return all.jump(from, to);
  };
  // Within a tenth of the smallest step.
  const auto steep = found(
    [](const double t) { return std::clamp((t - 0.5) * 1e5, 0., 1.); }, 0.4, 0.6);
  ASSERT_TRUE(steep);
  EXPECT_LT(steep->after - *steep->before, 1e-5);
  EXPECT_NEAR(*steep->before, 0.5, 1e-5);
  // Ramps, kinks and pulses that take longer are none.
  EXPECT_FALSE(found([](const double t) { return t; }, 0., 0.1));
  EXPECT_FALSE(found([](const double t) { return std::abs(t - 0.5); }, 0.4, 0.6));
  EXPECT_FALSE(
    found([](const double t) { return std::tanh((t - 0.5) / 1e-3); }, 0.4, 0.6));
  EXPECT_FALSE(found([](const double /*t*/) { return 0.3; }, 0.4, 0.6));
  // What is not that of rest from the start on.
  const auto at_start = found([](const double t) { return 0.3 + t; }, 0., 0.1);
  ASSERT_TRUE(at_start);
  EXPECT_FALSE(at_start->before);
  EXPECT_EQ(at_start->after, 0.1);
  EXPECT_EQ(at_start->from, 0.);
  EXPECT_TRUE(contains(jump_text(*at_start), "from the start on"));
}



namespace
{
  // Two cells, with data of all three kinds.
  const std::string all_kinds = R"(
subsection Geometry
  set Shape = block
  subsection block
    set Lengths     = 2, 1, 1
    set Cells       = 2, 1, 1
    set Tissue name = flesh
  end
end
subsection Tissues
  subsection flesh
    set Muscles = biceps
    subsection Neo-Hooke
      set a = 1
    end
  end
end
subsection Muscles
  subsection biceps
    set Fibres         = longitudinal
    set Active stretch = expression
    subsection expression
      set Formula = 0.9 - 0.1*t
    end
  end
end
subsection Boundary conditions
  set Names = wall, push, bed, drag
  subsection wall
    set Boundary = x min
    set Type     = displacement
    subsection displacement
      set Components   = x
      set Displacement = 0.1 + t^2; t; t
    end
  end
  subsection push
    set Boundary = x max
    set Type     = follower pressure
    subsection follower pressure
      set Pressure = 0.02 + t^3
    end
  end
  subsection bed
    set Boundary = y max
    set Type     = spring
  end
  subsection drag
    set Boundary = z max
    set Type     = dead traction
    subsection dead traction
      set Traction = 0; exp(t); t
    end
  end
end
)";
} // namespace



TEST(LoadPath, TakesAllDataFromOneTimeToAnother)
{
  Specimen     body(all_kinds);
  ChainModel  &model = *body.model;
  const Vector u     = body.random(1e-2, 1);
  const auto   r     = [&](const LoadTime &t) {
    Vector result = body.state.solution;
    EXPECT_TRUE(model.assembler.residual(u, t, result).valid());
    return result;
  };

  for (const bool from_rest : {false, true})
    {
      const std::optional<double> from =
        from_rest ? std::optional<double>() : 0.2;
      const LoadTime way = LoadTime::between(from, 0.7, 0.25);
      EXPECT_NEAR(body.parameters.anatomy.muscle(0).activation(way, 1, X),
                  0.75 * (from_rest ? 1. : 0.88) + 0.25 * 0.83,
                  1e-14);
      // From rest u is 0, and all of what is prescribed is missing.
      EXPECT_NEAR(
        model.supports.set_increments(body.state.solution, way),
        0.75 * (from_rest ? 0. : 0.14) + 0.25 * 0.59,
        1e-14);

      // Tractions are linear in their data: 4 r(way) = r(to) + 3 r(from). At
      // rest only the springs and the stress pull.
      Vector difference = r(way);
      difference *= 4.;
      difference.add(-1., r(0.7));
      difference.add(-3., r(LoadTime::between(from, 0.7, 1e-300)));
      EXPECT_LT(difference.linfty_norm(), 1e-13);
      if (!from_rest)
        {
          Vector same = r(0.2);
          same.add(-1., r(LoadTime::between(0.2, 0.7, 1e-300)));
          EXPECT_LT(same.linfty_norm(), 1e-13);
        }
    }
}



TEST(LoadPath, FollowsTheSameCurvesOnAllRanks)
{
  // Without the components of a displacement that are free.
  Specimen body(all_kinds);
  auto     curves = body.parameters.anatomy.load_curves(body.model->triangulation);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_EQ(curves[0].what + curves[0].where,
            "the active stretch of muscle 'biceps' in segment 1");
  EXPECT_EQ(curves[0].values.size(), 2u);
  EXPECT_EQ(curves[0].values[0](1.), 0.8);

  curves =
    body.parameters.boundary_conditions.load_curves(body.model->triangulation);
  std::vector<std::string> names;
  for (const LoadCurve &curve : curves)
    {
      names.push_back(curve.what + curve.where);
      EXPECT_FALSE(curve.values.empty());
      EXPECT_TRUE(std::isfinite(curve.values[0](0.)));
    }
  const std::string section = "Boundary conditions/";
  const std::string traction =
    "'" + section + "drag/dead traction/Traction'";
  EXPECT_EQ(names,
            (std::vector<std::string>{
              "the displacement of '" + section + "wall' along x",
              "'" + section + "push/follower pressure/Pressure'",
              traction,
              traction,
              traction}));
}
