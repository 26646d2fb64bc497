// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_measures_rest_volume_h
#define lumbricus_measures_rest_volume_h

#include <lumbricus/discretization/body.h>

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
  rest_volumes(const Body &body, const State &state);

  /**
   * Scale the shape X + u_vol of the liquid of every segment such that its
   * volume is the one given. Collective.
   */
  void
  set_rest_volumes(const std::vector<double> &volumes,
                   const Body                &body,
                   State                     &state);
} // namespace lumbricus

#endif
