// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_displacement_before_h
#define lumbricus_discretization_displacement_before_h

#include <lumbricus/core/nodal_history.h>
#include <lumbricus/discretization/body.h>

namespace lumbricus
{
  /** The displacement at the end of the last load step [mm], in runs where
   * muscles_feel_speed() alone: State::solution changes within a step. */
  extern const NodalHistory displacement_before;

  /** Whether what any muscle of the body does hangs on how fast its fibres
   * shorten. */
  bool
  muscles_feel_speed(const Anatomy &anatomy);

  /** The histories that a run has because of that. */
  std::set<std::string>
  histories_of_muscles(const Anatomy &anatomy);

  /** A load step is complete: remember where the body is, where muscles ask for
   * it. */
  void
  remember_displacement(const Body &body, State &state);
} // namespace lumbricus

#endif
