// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/continuation/continuation.h>
#include <lumbricus/program/chain_model.h>

namespace lumbricus
{
  bool
  Continuation::finished(const ChainModel &model, const State &state) const
  {
    return model.parameters.load_stepping.finished(state.time);
  }



  void
  Continuation::adapted(State &state) const
  {
    state.past.clear();
  }
} // namespace lumbricus
