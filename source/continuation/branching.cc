// SPDX-License-Identifier: LGPL-2.1-or-later
#include "branching.h"

#include <lumbricus/core/exceptions.h>

#include <deal.II/base/patterns.h>

#include <algorithm>

#include "path_way.h"

namespace lumbricus
{
  void
  Branching::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Follow branch",
                      wanted,
                      "[-] Look for bifurcations, where the body buckles, and go "
                      "on along the branch that begins at the first (1), the "
                      "second (2) and so on, to one side of the motion that is "
                      "soft there; 0: at none. Takes a load step or so in each "
                      "before it.",
                      dealii::Patterns::Integer(0));
  }



  std::optional<double>
  Branching::follow(ChainModel                             &model,
                      const std::function<Stability::Ends()> &stability,
                      const Aside                            &aside,
                      const State                            &state,
                      State                                  &next,
                      StepRecord                             &step,
                      Log                                    &log)
  {
    const double       last         = stiffness;
    const unsigned int n_before     = n_unstable;
    Stability::Ends    now;
    try
      {
        now = stability();
      }
    catch (const ExcNotConverged &)
      {
        return {}; // the tangent is singular: the next step has passed it
      }
    stiffness  = now.softest;
    n_unstable = now.unstable.size();
    if (!(last > 0.) || n_before >= wanted || n_unstable < wanted)
      return {};
    const Stability::Motion &softest = now.unstable.front();
    // Both branches come from where it is zero.
    const double part = last / (last - softest.stiffness);
    State::Past  fork{state.time + part * (next.time - state.time),
                     state.solution};
    fork.solution.sadd(1. - part, part, next.solution);
    log << "        another branch begins at the time " << fork.time
        << " or so, in a motion that is largest in "
        << model.stability().place(softest) << ": this run follows it\n";
    const State   from = next;
    const PathWay way(model, from, aside.displacement, softest.v);
    for (double distance = aside.distance; distance >= aside.smallest;
         distance *= 0.5)
      try
        {
          next      = way.step(distance, step);
          next.past = {fork};
          branched  = true;
          return way.length_to(next);
        }
      catch (const ExcNotConverged &)
        {
          ++step.n_cuts;
        }
    stiffness  = last;
    n_unstable = n_before;
    AssertThrow(false,
                ExcNotConverged("No equilibrium aside of the path is found at its "
                                "bifurcation. Set 'Follow branch' to 0, or "
                                "choose smaller steps"));
    return {};
  }



  Continuation::Numbers
  Branching::numbers() const
  {
    return {{"stiffness", stiffness},
            {"unstable", n_unstable},
            {"branched", branched ? 1. : 0.}};
  }



  void
  Branching::set_numbers(const Continuation::Numbers &numbers)
  {
    stiffness  = numbers.at("stiffness");
    n_unstable = std::max(0., numbers.at("unstable"));
    branched   = numbers.at("branched") != 0.;
  }
} // namespace lumbricus
