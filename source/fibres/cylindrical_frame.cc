// SPDX-License-Identifier: LGPL-2.1-or-later
#include "cylindrical_frame.h"

#include <lumbricus/core/exceptions.h>
#include <lumbricus/parameters/expression.h>

#include <cmath>
#include <sstream>

namespace lumbricus
{
  dealii::Tensor<1, dim>
  axial_direction()
  {
    dealii::Tensor<1, dim> e_x;
    e_x[0] = 1.;
    return e_x;
  }



  CylindricalFrame
  CylindricalFrame::at(const dealii::Point<dim> &X, const std::string &field)
  {
    const double r = std::hypot(X[1], X[2]);
    AssertThrow(r > 1e-12 * std::abs(X[0]) && r > 0.,
                ExcInput("The fibre field '" + field +
                         "' has no direction at the point " + point_text(X) +
                         ", which is on the x axis. Give the tissue there "
                         "another fibre field."));

    CylindricalFrame frame;
    frame.e_r[1]     = X[1] / r;
    frame.e_r[2]     = X[2] / r;
    frame.e_theta[1] = -frame.e_r[2];
    frame.e_theta[2] = frame.e_r[1];
    return frame;
  }
} // namespace lumbricus
