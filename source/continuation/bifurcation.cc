// SPDX-License-Identifier: LGPL-2.1-or-later
#include "bifurcation.h"

#include <lumbricus/core/exceptions.h>

namespace lumbricus
{
  namespace
  {
    Stability
    stability_of(ChainModel &model, const State &state)
    {
      model.set_to(state);
      model.equilibrium.linearise({state.solution, state.globals});
      return Stability(model.body,
                       model.assembler.tangent(),
                       model.equilibrium.linearised_border(),
                       *model.parameters.linear_solver.get());
    }
  } // namespace



  std::optional<Stability::Motion>
  softest_motion(ChainModel &model, const State &state)
  {
    try
      {
        return stability_of(model, state).softest_motion();
      }
    catch (const ExcNotConverged &)
      {
        return {};
      }
  }



  std::string
  place_of(ChainModel              &model,
           const State             &state,
           const Stability::Motion &motion)
  {
    return stability_of(model, state).place(motion);
  }
} // namespace lumbricus
