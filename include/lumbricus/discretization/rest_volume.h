// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_rest_volume_h
#define lumbricus_discretization_rest_volume_h

#include <lumbricus/anatomy/anatomy.h>
#include <lumbricus/discretization/shape_cache.h>

#include <vector>

namespace lumbricus
{
  /**
   * The stress-free volume of the liquid of every segment [mm^3],
   *
   *   V_s = int det(I + Grad u_vol) dV,
   *
   * of the part of the cross-section that has a mesh. Nothing may change it but
   * a reset that forgets the volume. Collective.
   */
  std::vector<double>
  rest_volumes(const MixedSpace &space,
               const ShapeCache &shapes,
               const Anatomy    &anatomy,
               const State      &state);

  /**
   * Scale the shape X + u_vol of the liquid of every segment such that its
   * volume is the one given. Collective.
   */
  void
  set_rest_volumes(const std::vector<double> &volumes,
                   const MixedSpace          &space,
                   const ShapeCache          &shapes,
                   const Anatomy             &anatomy,
                   State                     &state);
} // namespace lumbricus

#endif
