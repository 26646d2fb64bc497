// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/fibres/fibre_field.h>
#include <lumbricus/parameters/registry.h>

#include "cylindrical_frame.h"

namespace lumbricus
{
  /** f = e_x. */
  class LongitudinalFibres : public FibreField
  {
  public:
    dealii::Tensor<1, dim>
    direction(const dealii::Point<dim> & /*X*/) const override
    {
      return axial_direction();
    }
  };



  static const Register<FibreField, LongitudinalFibres>
    longitudinal_fibres("longitudinal", "along the axis of the body (x).");
} // namespace lumbricus
