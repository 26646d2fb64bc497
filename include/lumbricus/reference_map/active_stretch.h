// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_reference_map_active_stretch_h
#define lumbricus_reference_map_active_stretch_h

#include <lumbricus/reference_map/reference_point.h>

#include <vector>

namespace lumbricus
{
  /** A fibre family at a point: unit vector f, active stretch lambda > 0 where
   * the volume is kept, and growth of the volume. */
  struct ActiveFibre
  {
    dealii::Tensor<1, dim> f;      ///< at rest
    double                 lambda; ///< stress-free length / length at rest
    double volume = 1.; ///< stress-free volume / volume at rest, > 0
  };

  /**
   * The reference map of a muscle,
   *
   *   G = exp( sum_i ln(lambda_i) (3/2 f_i x f_i - 1/2 I) ),
   *   J_v = product_i v_i,   v_i = ActiveFibre::volume:
   *
   * each fibre family's stress-free length is lambda_i times the length it
   * has in the mesh, before all grow by J_v^(1/3); det G = 1, and the order of
   * the families plays no role.
   */
  ReferencePoint
  active_stretch_map(const std::vector<ActiveFibre> &fibres);
} // namespace lumbricus

#endif
