// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/reference_map/fluid_reset.h>

#include <cmath>

namespace lumbricus
{
  const NodalHistory rest_displacement{"u_ref"};
  const NodalHistory volume_displacement{"u_vol"};



  ReferencePoint
  rest_shape_map(const dealii::Tensor<2, dim> &F_r,
                 const dealii::Tensor<2, dim> &F_v)
  {
    ReferencePoint reference;
    reference.G_inverse = std::cbrt(determinant(F_r)) * invert(F_r);
    reference.J_v       = determinant(F_v);
    return reference;
  }
} // namespace lumbricus
