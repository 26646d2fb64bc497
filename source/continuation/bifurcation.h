// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_continuation_bifurcation_h
#define lumbricus_continuation_bifurcation_h

#include <lumbricus/core/state.h>
#include <lumbricus/equilibrium/stability.h>
#include <lumbricus/program/chain_model.h>

#include <optional>

namespace lumbricus
{
  /** The softest motion of the body in equilibrium at @p state, which becomes the
   * model's; none where the tangent is singular. Collective. */
  std::optional<Stability::Motion>
  softest_motion(ChainModel &model, const State &state);

  /** In words, where a motion is largest, see Stability::place(). Collective. */
  std::string
  place_of(ChainModel              &model,
           const State             &state,
           const Stability::Motion &motion);
} // namespace lumbricus

#endif
