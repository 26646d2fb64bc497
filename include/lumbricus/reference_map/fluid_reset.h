// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_reference_map_fluid_reset_h
#define lumbricus_reference_map_fluid_reset_h

#include <lumbricus/core/nodal_history.h>
#include <lumbricus/reference_map/reference_point.h>

namespace lumbricus
{
  /** u_ref [mm]: where the liquid is free of shear; unused elsewhere. */
  extern const NodalHistory rest_displacement;

  /** u_vol [mm]: where the liquid has its stress-free volume; zero as long as
   * that is the volume of the mesh. */
  extern const NodalHistory volume_displacement;



  /**
   * The reference map of a rubber fluid that is free of shear in the shape
   * x = X + u_ref, and has its stress-free volume in the shape x = X + u_vol:
   * with F_r = I + Grad u_ref and F_v = I + Grad u_vol,
   *
   *   G = (det F_r)^(-1/3) F_r,   J_v = det F_v.
   *
   * A reset that forgets the shape only leaves u_vol as it is. One that forgets
   * the volume as well (paper, "Coupling of liquid filling and elastic
   * membrane") makes it the same as u_ref.
   */
  ReferencePoint
  rest_shape_map(const dealii::Tensor<2, dim> &F_r,
                 const dealii::Tensor<2, dim> &F_v);
} // namespace lumbricus

#endif
