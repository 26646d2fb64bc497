// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/reference_map/fluid_reset.h>

#include <cmath>

namespace lumbricus
{
  ReferencePoint
  rest_shape_map(const dealii::Tensor<2, dim> &F_r, const ResetMode mode)
  {
    const double   J_r = determinant(F_r);
    ReferencePoint reference;
    reference.G_inverse = std::cbrt(J_r) * invert(F_r);
    reference.J_v       = (mode == ResetMode::full) ? J_r : 1.;
    return reference;
  }
} // namespace lumbricus
