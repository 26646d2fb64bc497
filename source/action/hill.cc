// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/action/tension_curve.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/utilities.h>

namespace lumbricus
{
  /**
   * With w = v/v_max, the rate of the stretch in parts of the fastest,
   *
   *   f_v = 0                          for w <= -1,
   *   f_v = (1 + w)/(1 - w/k)          for -1 <= w <= 0  (Hill, Proc. R. Soc. B
   *                                    126 (1938) 136-195),
   *   f_v = N - (N - 1)/(1 + c w)      for w >= 0, c = (1 + 1/k)/(N - 1).
   *
   * The second is Hill's (T + a)(v + b) = (T0 + a) b with a = k T0 and
   * b = k v_max. The third, for a fibre that is stretched, is a hyperbola to N
   * whose slope at rest is that of the second; measured slopes there are steeper.
   */
  class Hill : public ForceVelocity
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("Fastest",
                        v_max,
                        "[1/time] How fast a fibre without a load shortens, in "
                        "lengths at rest.",
                        PositiveNumber());
      prm.add_parameter("Curvature",
                        k,
                        "[1] Hill's a/T0: less than 1 is more curved. 0.25 is "
                        "that of most muscles.",
                        PositiveNumber());
      prm.add_parameter("Largest",
                        N,
                        "[1] The part of its tension to which that of a fibre "
                        "tends that is stretched ever faster: more than 1.",
                        PositiveNumber());
    }

    void
    check_parameters() const override
    {
      AssertThrow(N > 1.,
                  ExcParameter("Largest",
                               "is " + dealii::Utilities::to_string(N) +
                                 ", but has to be more than 1, the part of a "
                                 "fibre at rest."));
    }

    CurvePoint
    at(const double v) const override
    {
      const double w = v / v_max;
      if (w <= -1.)
        return {0., 0.};
      if (w < 0.)
        {
          const double d = 1. - w / k;
          return {(1. + w) / d, (1. + 1. / k) / (d * d) / v_max};
        }
      const double c = (1. + 1. / k) / (N - 1.), d = 1. + c * w;
      return {N - (N - 1.) / d, (1. + 1. / k) / (d * d) / v_max};
    }

  private:
    double v_max = 1.;
    double k     = 0.25;
    double N     = 1.8;
  };



  static const Register<ForceVelocity, Hill>
    hill("Hill",
         "Hill's hyperbola where the fibre shortens, and another one where it is "
         "stretched.");
} // namespace lumbricus
