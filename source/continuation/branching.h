// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_continuation_branching_h
#define lumbricus_continuation_branching_h

#include <lumbricus/continuation/continuation.h>
#include <lumbricus/equilibrium/stability.h>
#include <lumbricus/program/chain_model.h>

#include <functional>
#include <optional>

namespace lumbricus
{
  /**
   * Looks for a bifurcation of a path of equilibria, the first or another one, and
   * leads to the branch that begins there. With the equation that says where a
   * step ends the tangent is regular where the load parameter turns: so one more
   * motion has a negative stiffness (PathEquation::stability()) behind a
   * bifurcation only.
   */
  class Branching
  {
  public:
    /** "Follow branch". */
    void
    declare_parameters(dealii::ParameterHandler &prm);

    /** Whether one is to be followed, and is not yet. */
    bool
    is_looked_for() const
    {
      return wanted > 0 && !branched;
    }

    /** How far to go aside, at first and at least, as PathWay::step(); and the
     * displacement of its metric. */
    struct Aside
    {
      double distance;     ///< [time]
      double smallest;     ///< [time]
      double displacement; ///< [time/mm]
    };

    /**
     * After a step from @p state to @p next, at which @p stability says how
     * stable the body is: where it has passed the bifurcation put a state of the other branch into
     * @p next, whose past is where the branches meet.
     * @return how far that is from where @p next was [time]; none if it has
     * passed none. Throws ExcNotConverged. Collective.
     */
    std::optional<double>
    follow(ChainModel                             &model,
           const std::function<Stability::Ends()> &stability,
           const Aside                            &aside,
           const State                            &state,
           State                                  &next,
           StepRecord                             &step,
           Log                                    &log);

    /** At the last step, "stiffness" of the softest motion, and how many are
     * "unstable"; "branched": whether the first branch was left. */
    Continuation::Numbers
    numbers() const;

    /** Go on with those. */
    void
    set_numbers(const Continuation::Numbers &numbers);

  private:
    unsigned int wanted = 0;
    /** The least positive one [N/mm^4]; 0: not known. */
    double       stiffness  = 0.;
    unsigned int n_unstable = 0;
    bool         branched   = false;
  };
} // namespace lumbricus

#endif
