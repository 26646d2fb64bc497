// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/activation/activation.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/geometry/segment_expression.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace lumbricus
{
  /**
   * A wave of contraction that travels along the chain, as in peristalsis:
   * in segment s = 1, ..., n at time t
   *
   *   lambda = 1 - A r(t) h(t/T -+ (s-1)/Lambda + phi)
   *
   * or, where the activation is 0 at rest, A r h, with the amplitude A < 1, the period T, the wavelength Lambda in segments
   * (minus: towards the tail, plus: towards the head) and the phase phi. A and
   * Lambda may be formulas in s and n. The pulse h has period 1 and lasts for the part d of it (the duty),
   *
   *   h(p) = (1 - cos(2 pi p/d))/2  for 0 <= p < d,   0 for d <= p < 1,
   *
   * and r(t) = 3q^2 - 2q^3 with q = t/T_ramp, held at 0 before and at 1 after,
   * is the ramp-in. Both have continuous derivatives.
   */
  class WaveActivation : public Activation
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    void
    check_parameters() const override;

    /** Throws ExcInput where a formula gives no amplitude or wavelength. */
    void
    initialize(const std::string &section, const Geometry &geometry) override;

    double
    value(const double              t,
          const unsigned int        segment,
          const dealii::Point<dim> &X) const override;

    /** The times at which pulses begin, peak and end. */
    std::vector<double>
    marks(const unsigned int segment,
          const double       from,
          const double       to) const override;

  private:
    /** By how many periods the pulses of @p segment are ahead of time. */
    double
    lead(const unsigned int segment) const;

    double
    pulse(const double phase) const;

    double
    ramp(const double t) const;

    SegmentExpression amplitude_formula  = {"Amplitude", "0.2"};
    SegmentExpression wavelength_formula = {"Wavelength", "4"};

    /** By segment, from zero. */
    std::vector<double> amplitudes, wavelengths;

    double      period     = 1.;
    std::string towards    = "towards tail";
    double      duty       = 0.5;
    double      phase      = 0.;
    double      ramp_in    = 1.;
  };



  void
  WaveActivation::declare_parameters(dealii::ParameterHandler &prm)
  {
    using dealii::Patterns::Double;

    amplitude_formula.declare_parameter(
      prm,
      "[1] By how much the pulse shortens the fibres: the active stretch at its "
      "peak is 1 - Amplitude. Less than 1; negative values lengthen the fibres. "
      "Of an active stress it is the activation at the peak, from 0 to 1. "
      "A formula in the number s of the segment and the number n of segments.");
    wavelength_formula.declare_parameter(
      prm,
      "[segments] Number of segments from one pulse to the next; need not be "
      "whole. A formula in s and n, as 'n/2' for two waves on the body.");
    prm.add_parameter("Period",
                      period,
                      "[time] Time from one pulse of a segment to the next.",
                      PositiveNumber());
    prm.add_parameter("Direction",
                      towards,
                      "[towards tail or towards head] Where the pulses travel.",
                      dealii::Patterns::Selection("towards tail|towards head"));
    prm.add_parameter("Duty",
                      duty,
                      "[1] Part of the period during which the muscle of a "
                      "segment is active: more than 0, at most 1.",
                      PositiveNumber());
    prm.add_parameter("Phase",
                      phase,
                      "[periods] By how much the wave is ahead: at time 0, the "
                      "pulse of segment 1 has been running for this long. Two "
                      "muscles half a period apart take turns.",
                      Double());
    prm.add_parameter("Ramp-in",
                      ramp_in,
                      "[time] Over this time from 0 on the wave grows smoothly "
                      "to its full amplitude. With 0 it is there at once.",
                      Double(0.));
  }



  void
  WaveActivation::check_parameters() const
  {
    for (const SegmentExpression *formula :
         {&amplitude_formula, &wavelength_formula})
      AssertThrow(!formula->depends_on_place_or_time(),
                  ExcParameter(formula->parameter(),
                               "is '" + formula->text() +
                                 "', but is a number of each segment. Use s and "
                                 "n, or the activation 'expression'."));
    AssertThrow(duty <= 1.,
                ExcParameter("Duty",
                             "is " + dealii::Utilities::to_string(duty) +
                               ", but is a part of the period: give at most "
                               "1."));
  }



  void
  WaveActivation::initialize(const std::string &section,
                             const Geometry    &geometry)
  {
    const auto evaluate = [&](SegmentExpression &formula,
                              const auto        &is_possible,
                              const std::string &why) {
      formula.initialize(geometry);
      std::vector<double> values;
      for (unsigned int s = 0; s < geometry.n_segments(); ++s)
        {
          values.push_back(formula.value(s, 0.));
          AssertThrow(is_possible(values.back()),
                      ExcInput(about_parameter(
                        section + "/" + formula.parameter(),
                        "is " + dealii::Utilities::to_string(values.back()) +
                          " for segment " + std::to_string(s + 1) + ", but " +
                          why)));
        }
      return values;
    };
    amplitudes = evaluate(amplitude_formula,
                          [this](const double a) {
                            return (a < 1. && a > -1e100) ||
                                   (a == 1. && contracted_by(a) > 0.);
                          },
                          "has to be less than 1: the active stretch 1 - "
                          "Amplitude is greater than zero.");
    wavelengths =
      evaluate(wavelength_formula,
               [](const double l) { return l >= 1e-100 && l <= 1e100; },
               "has to be a number > 0.");
  }



  double
  WaveActivation::pulse(const double p) const
  {
    const double q = (p - std::floor(p)) / duty;
    return q < 1. ? (1. - std::cos(2. * dealii::numbers::PI * q)) / 2. : 0.;
  }



  double
  WaveActivation::ramp(const double t) const
  {
    if (ramp_in == 0.)
      return 1.;
    const double q = std::clamp(t / ramp_in, 0., 1.);
    return q * q * (3. - 2. * q);
  }



  double
  WaveActivation::value(const double       t,
                        const unsigned int segment,
                        const dealii::Point<dim> & /*X*/) const
  {
    return contracted_by(amplitudes[segment - 1] * ramp(t) *
                         pulse(t / period + lead(segment)));
  }



  double
  WaveActivation::lead(const unsigned int segment) const
  {
    const double lag = (segment - 1.) / wavelengths[segment - 1];
    return (towards == "towards tail" ? -lag : lag) + phase;
  }



  std::vector<double>
  WaveActivation::marks(const unsigned int segment,
                        const double       from,
                        const double       to) const
  {
    // The first hundred pulses are more than a step can go past.
    constexpr unsigned int most_pulses = 100;
    std::vector<double>    times;
    const double           ahead = lead(segment);
    const double           first = std::floor(from / period + ahead);
    for (unsigned int i = 0; i < most_pulses; ++i)
      for (const double part : {0., duty / 2., duty})
        {
          const double t = (first + i + part - ahead) * period;
          if (t >= to)
            return times;
          if (t > from)
            times.push_back(t);
        }
    return times;
  }



  static const Register<Activation, WaveActivation>
    wave_activation("wave", "a pulse that travels along the chain.");
} // namespace lumbricus
