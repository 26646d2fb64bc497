// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_nodal_displacement_h
#define lumbricus_discretization_nodal_displacement_h

#include <lumbricus/discretization/mixed_space.h>

namespace lumbricus
{
  /** Write the displacement of @p solution, a State::solution, to @p history, one of
   * State::histories: its values at the nodes of each cell [mm]. Collective. */
  void
  write_history(const MixedSpace &space,
                const Vector     &solution,
                Vector           &history);

  /** Write @p history, one of State::histories, to the displacement of
   * @p solution, a State::solution [mm]. Of a node that cells do not agree about,
   * any of their values. */
  void
  write_displacement(const MixedSpace &space,
                     const Vector     &history,
                     Vector           &solution);
} // namespace lumbricus

#endif
