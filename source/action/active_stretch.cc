// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/action/muscle_action.h>
#include <lumbricus/parameters/registry.h>

#include <cmath>

namespace lumbricus
{
  /**
   * The activation is the active stretch lambda: the length at which fibres are
   * free of stress, relative to their length at rest. It goes into the
   * reference map, see active_stretch_map(); the stress is that of the law.
   */
  class ActiveStretch : public MuscleAction
  {
  public:
    ActiveStretch()
      : MuscleAction("active stretch",
                     1.,
                     0.,
                     "How the stress-free length of the fibres, relative to "
                     "their length at rest, changes with time.")
    {}

    std::string
    requirement(const double lambda) const override
    {
      return lambda > 0. && std::isfinite(lambda) ?
               "" :
               "a number > 0 (1 is rest, 0.8 a contraction by 20%)";
    }

    double
    strength(const double lambda, const double /*tension*/) const override
    {
      return std::log(lambda);
    }

    void
    add_stretch(const MuscleFibre        &fibre,
                std::vector<ActiveFibre> &stretches) const override
    {
      stretches.push_back({fibre.f, fibre.activation});
    }
  };



  static const Register<MuscleAction, ActiveStretch>
    active_stretch("active stretch",
                   "its fibres are free of stress at another length than at "
                   "rest.");
} // namespace lumbricus
