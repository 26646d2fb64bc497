// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/activation/activation.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/registry.h>

#include <cmath>

namespace
{
  using lumbricus::dim;

  /** Every segment twitches with a period of its own: lambda = 1 - 0.1
   * sin^2(pi t / (T s)), s = 1, 2, ... from the head. */
  class Twitch : public lumbricus::Activation
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("Period",
                        period,
                        "[time] Of the first segment.",
                        lumbricus::PositiveNumber());
    }

    double
    value(const double       t,
          const unsigned int segment,
          const dealii::Point<dim> &) const override
    {
      return 1. - 0.1 * std::pow(std::sin(M_PI * t / (period * segment)), 2);
    }

  private:
    double period = 1.;
  };

  const lumbricus::Register<lumbricus::Activation, Twitch>
    twitch("twitch", "10 % shorter at the height of each twitch.");
} // namespace
