// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/action/tension_curve.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/registry.h>

#include <algorithm>
#include <cmath>

namespace lumbricus
{
  /**
   * Three parabolas in x = l/l_best (Blemker, Pinsky and Delp, J. Biomech. 38
   * (2005) 657-665, doi:10.1016/j.jbiomech.2004.04.009),
   *
   *   f_l = 9 (x - 0.4)^2   on [0.4, 0.6],
   *   f_l = 1 - 4 (1 - x)^2 on [0.6, 1.4],
   *   f_l = 9 (x - 1.6)^2   on [1.4, 1.6],
   *
   * and zero elsewhere. The slope jumps from 3.6 to 3.2 at x = 0.6, and the
   * same at 1.4.
   */
  class Blemker : public ForceLength
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("Best length",
                        best,
                        "[1] The stretch at which a fibre has all of its tension. "
                        "Without any at less than 0.4 and more than 1.6 of it.",
                        PositiveNumber());
    }

    CurvePoint
    at(const double l) const override
    {
      const double from_best = l / best - 1.;
      const double far       = std::abs(from_best);
      if (far <= 0.4)
        return {1. - 4. * far * far, -8. * from_best / best};
      const double to_end = std::max(0.6 - far, 0.);
      return {9. * to_end * to_end,
              -std::copysign(18. * to_end, from_best) / best};
    }

  private:
    double best = 1.;
  };



  static const Register<ForceLength, Blemker>
    blemker("Blemker",
            "three parabolas, as skeletal muscle (Blemker et al. 2005).");
} // namespace lumbricus
