// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/fibres/fibre_field.h>
#include <lumbricus/parameters/registry.h>

#include "cylindrical_frame.h"

namespace lumbricus
{
  /** f = e_r. */
  class RadialFibres : public FibreField
  {
  public:
    dealii::Tensor<1, dim>
    direction(const dealii::Point<dim> &X) const override
    {
      return CylindricalFrame::at(X, "radial").e_r;
    }
  };



  static const Register<FibreField, RadialFibres>
    radial_fibres("radial", "away from the x axis.");
} // namespace lumbricus
