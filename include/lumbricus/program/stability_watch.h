// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_stability_watch_h
#define lumbricus_program_stability_watch_h

#include <lumbricus/core/log.h>
#include <lumbricus/equilibrium/stability.h>
#include <lumbricus/parameters/parameter_owner.h>

namespace lumbricus
{
  class ChainModel;

  /**
   * Looks after every load step whether equilibrium is stable. Newton's method
   * follows an equilibrium through a bifurcation and does not notice, though a
   * real body would leave it there and buckle.
   */
  class StabilityWatch : public ParameterOwner
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    /**
     * @return the stiffness of the body at @p state in its softest motion, see
     * Stability, or in the unstable one there is; not a number where nobody
     * asked. Says in @p log when it becomes negative. Collective.
     */
    double
    look(ChainModel &model, const State &state, Log &log);

  private:
    bool watch = false;

    /** The motion of negative stiffness; without a vector for none. */
    Stability::Motion unstable;
  };
} // namespace lumbricus

#endif
