// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/action/muscle_action.h>
#include <lumbricus/parameters/registry.h>

#include <cmath>
#include <string>

namespace lumbricus
{
  /** A growth: the activation is theta, a stress-free length relative to that at
   * rest, for which stress-free volume is gained or lost. */
  class Grows : public MuscleAction
  {
  public:
    Grows()
      : MuscleAction("growth",
                     1.,
                     2.,
                     "How the stress-free length of the tissue, in all "
                     "directions or along the fibres alone, relative to that at "
                     "rest, changes with time.")
    {}

    std::string
    requirement(const double theta) const override
    {
      return theta > 0. && std::isfinite(theta) ?
               "" :
               "a number > 0 (1 is rest, 1.2 a growth by 20%)";
    }
  };



  /** In all directions: theta I takes the mesh to the stress-free shape, so that G
   * stays as it is and J_v is theta^3 times as large. */
  class Growth : public Grows
  {
  public:
    double
    strength(const double /*theta*/, const double /*tension*/) const override
    {
      return 0.; // no direction is different from others
    }

    void
    add_stretch(const MuscleFibre        &fibre,
                std::vector<ActiveFibre> &stretches) const override
    {
      const double theta = fibre.activation;
      stretches.push_back({fibre.f, 1., theta * theta * theta});
    }
  };



  /**
   * Along the fibres alone: I + (theta - 1) f x f takes the mesh to the
   * stress-free shape, so that J_v is theta times as large, and G is that of the
   * active stretch theta^(2/3).
   */
  class FibreGrowth : public Grows
  {
  public:
    double
    strength(const double theta, const double /*tension*/) const override
    {
      return 2. / 3. * std::log(theta);
    }

    void
    add_stretch(const MuscleFibre        &fibre,
                std::vector<ActiveFibre> &stretches) const override
    {
      const double theta = fibre.activation;
      stretches.push_back({fibre.f, std::cbrt(theta * theta), theta});
    }
  };



  static const Register<MuscleAction, Growth>
    growth("growth",
           "the tissue grows in all directions, as if its fibres were in all.");
  static const Register<MuscleAction, FibreGrowth>
    fibre_growth("growth along fibres",
                 "the tissue grows along its fibres, and not across.");
} // namespace lumbricus
