// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/fibres/fibre_field.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/patterns.h>

#include <cmath>

#include "cylindrical_frame.h"

namespace lumbricus
{
  /** f = cos(a) e_x + sin(a) e_theta with the angle a. */
  class HelicalFibres : public FibreField
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter(
        "Angle",
        angle,
        "[degrees] Angle between the fibres and the x axis: 0 is longitudinal, "
        "90 circumferential. Fibres of a positive angle wind like a "
        "right-handed screw, those of a negative one like a left-handed.",
        dealii::Patterns::Double(-180, 180));
    }

    dealii::Tensor<1, dim>
    direction(const dealii::Point<dim> &X) const override
    {
      const double a = angle * dealii::numbers::PI / 180;
      return std::cos(a) * axial_direction() +
             std::sin(a) * CylindricalFrame::at(X, "helical").e_theta;
    }

  private:
    double angle = 45.;
  };



  static const Register<FibreField, HelicalFibres>
    helical_fibres("helical", "on helices about the x axis, at a given angle.");
} // namespace lumbricus
