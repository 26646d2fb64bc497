// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_output_obstacle_surfaces_h
#define lumbricus_output_obstacle_surfaces_h

#include <lumbricus/contact/obstacle.h>
#include <lumbricus/core/state.h>
#include <lumbricus/discretization/body.h>
#include <lumbricus/terms/boundary_conditions.h>

#include <vector>

namespace lumbricus
{
  /** The surfaces of all obstacles near the whole body in @p state, by the
   * contacts among @p conditions in their order. Collective. */
  std::vector<Obstacle::Surface>
  obstacle_surfaces(const Body               &body,
                    const BoundaryConditions &conditions,
                    const State              &state);
} // namespace lumbricus

#endif
