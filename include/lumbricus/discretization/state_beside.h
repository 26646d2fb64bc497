// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_state_beside_h
#define lumbricus_discretization_state_beside_h

#include <lumbricus/discretization/mixed_space.h>

namespace lumbricus
{
  /** @name A state beside a state
   * The same body as it would be had it come another way. It goes along with a
   * state wherever that is copied, taken to another mesh or written, since it is
   * among its histories and globals, by names of its own: all histories and
   * globals of the one beside, its displacement and its time. Its pressures of
   * cells, which nothing is remembered by, and its past are not.
   * @{
   */

  /** Whether @p state has one beside it. */
  bool
  has_state_beside(const State &state);

  /** The State::time of the one beside @p state, which has one. */
  double
  time_beside(const State &state);

  /** Put @p beside, which ends a load step, beside @p state, in place of the one
   * that may be there. Collective. */
  void
  put_beside(const MixedSpace &space, const State &beside, State &state);

  /** The state beside @p state, with pressures of zero in cells. */
  State
  state_beside(const MixedSpace &space, const State &state);

  /** The state @p state without the one beside it and without a past. */
  State
  without_state_beside(const State &state);

  /** @} */
} // namespace lumbricus

#endif
