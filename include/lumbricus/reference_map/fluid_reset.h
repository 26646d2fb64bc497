// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_reference_map_fluid_reset_h
#define lumbricus_reference_map_fluid_reset_h

#include <lumbricus/reference_map/reference_point.h>

namespace lumbricus
{
  /** What a reset forgets. */
  enum class ResetMode
  {
    /** The shape; volume and pressure never. */
    isochoric,
    /**
     * Shape and volume, as in the paper ("Coupling of liquid filling and
     * elastic membrane"): at nu < 0.5 a volume defect accumulates.
     */
    full
  };

  /**
   * The reference map of a rubber fluid that is free of stress in the shape
   * x = X + u_ref, where F_r = I + Grad u_ref:
   *
   *   G = (det F_r)^(-1/3) F_r,
   *   J_v = 1 (isochoric) or det F_r (full).
   */
  ReferencePoint
  rest_shape_map(const dealii::Tensor<2, dim> &F_r, const ResetMode mode);
} // namespace lumbricus

#endif
