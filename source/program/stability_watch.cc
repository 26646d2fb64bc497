// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/interruption.h>
#include <lumbricus/program/chain_model.h>
#include <lumbricus/program/stability_watch.h>

#include <limits>

namespace lumbricus
{
  void
  StabilityWatch::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Stability");
    prm.add_parameter("Watch",
                      watch,
                      "Whether to look after every load step if the body is "
                      "stable, and to say when it is not any more: when it "
                      "would buckle. Takes half a load step or so. steps.csv "
                      "has the stiffness of the softest motion.");
    prm.leave_subsection();
  }



  double
  StabilityWatch::look(ChainModel &model, const State &state, Log &log)
  {
    if (!watch)
      return std::numeric_limits<double>::quiet_NaN();
    // What would be saved is the state before this step, which the mesh may not
    // be that of any more.
    const Uninterrupted        uninterrupted;
    dealii::TimerOutput::Scope scope(model.timer, "stability");
    model.set_to(state);
    model.equilibrium.linearise({state.solution, state.globals});
    const Stability stability = model.stability();
    try
      {
        auto softest = stability.softest_motion();
        // Where the body is unstable other motions may have less stiffness,
        // regardless of its sign, than the one that is.
        const bool was_unstable =
          unstable.v.size() == model.space.dof_handler.n_dofs();
        if (was_unstable && softest.stiffness > 0.)
          {
            const auto followed = stability.follow(unstable, softest);
            if (followed.stiffness < 0.)
              softest = followed;
          }
        unstable = softest.stiffness < 0. ? softest : Stability::Motion();
        if (softest.stiffness < 0. && !was_unstable)
          log << "        the body is not stable any more: its stiffness in a "
                 "motion that is largest in "
              << stability.place(softest)
              << " is negative.\n        A real body would buckle or snap "
                 "there; what follows is the equilibrium that it leaves.\n";
        return softest.stiffness;
      }
    catch (const ExcNotConverged &)
      {
        // As good as singular.
        return 0.;
      }
    catch (const ExcSolveFailed &exception)
      {
        log << "        the stability is not known: "
            << plain_message(exception) << "\n";
        return std::numeric_limits<double>::quiet_NaN();
      }
  }
} // namespace lumbricus
