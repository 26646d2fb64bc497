// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_displacement_before_h
#define lumbricus_discretization_displacement_before_h

#include <lumbricus/core/nodal_history.h>
#include <lumbricus/discretization/body.h>

namespace lumbricus
{
  /** The displacement at the end of the last load step [mm], in runs where
   * way_counts() alone: State::solution changes within a step. */
  extern const NodalHistory displacement_before;

  /** Whether what any muscle of the body does hangs on how fast its fibres
   * shorten. */
  bool
  muscles_feel_speed(const Anatomy &anatomy);

  /** Whether that or a viscous branch hangs on where the body was. */
  bool
  way_counts(const Anatomy &anatomy);

  /** A load step is complete: remember where the body is, where way_counts(). */
  void
  remember_displacement(const Body &body, State &state);
} // namespace lumbricus

#endif
