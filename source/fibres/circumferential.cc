// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/fibres/fibre_field.h>
#include <lumbricus/parameters/registry.h>

#include "cylindrical_frame.h"

namespace lumbricus
{
  /** f = e_theta. */
  class CircumferentialFibres : public FibreField
  {
  public:
    dealii::Tensor<1, dim>
    direction(const dealii::Point<dim> &X) const override
    {
      return CylindricalFrame::at(X, "circumferential").e_theta;
    }
  };



  static const Register<FibreField, CircumferentialFibres>
    circumferential_fibres("circumferential", "around the x axis.");
} // namespace lumbricus
