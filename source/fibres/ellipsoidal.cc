// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/fibres/fibre_field.h>
#include <lumbricus/geometry/ellipsoid_shells.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/patterns.h>

#include <cmath>

#include "cylindrical_frame.h"

namespace lumbricus
{
  /**
   * The rule-based fibres of the heart's wall (Land et al., Proc. R. Soc. A 471,
   * 20150641, 2015): f = sin(a) n(dx/dtheta) + cos(a) e_theta on the ellipsoid
   * of depth t, with an angle a that is linear in t.
   */
  class EllipsoidalFibres : public FibreField
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      const dealii::Patterns::Double degrees(-180., 180.);
      prm.add_parameter("Angle inside",
                        inside,
                        "[degrees] Angle between the fibres and the circles "
                        "around the axis at the inner surface: 90 is from the "
                        "apex to the base.",
                        degrees);
      prm.add_parameter("Angle outside",
                        outside,
                        "[degrees] The same at the outer surface; between them "
                        "the angle is linear in the depth.",
                        degrees);
    }

    void
    initialize(const std::string &section, const Geometry &geometry) override
    {
      const auto *body = dynamic_cast<const HasEllipsoidShells *>(&geometry);
      AssertThrow(body != nullptr,
                  ExcInput("Section '" + section +
                           "': ellipsoidal fibres are for the shape 'truncated "
                           "ellipsoid'. Choose other fibres for this shape."));
      shells = body->shells();
    }

    dealii::Tensor<1, dim>
    direction(const dealii::Point<dim> &X) const override
    {
      const CylindricalFrame frame = CylindricalFrame::at(X, "ellipsoidal");
      const auto             place = shells.at(X[0], frame.e_r * X);
      const double           a =
        (inside + (outside - inside) * place.depth) * dealii::numbers::PI / 180.;
      dealii::Tensor<1, dim> up =
        shells.long_radius(place.depth) * std::sin(place.theta) *
          axial_direction() +
        shells.short_radius(place.depth) * std::cos(place.theta) * frame.e_r;
      return std::sin(a) * up / up.norm() + std::cos(a) * frame.e_theta;
    }

  private:
    double          inside  = 90.;
    double          outside = -90.;
    EllipsoidShells shells;
  };



  static const Register<FibreField, EllipsoidalFibres>
    ellipsoidal_fibres("ellipsoidal",
                       "on the shells of a truncated ellipsoid, at an angle "
                       "that turns with the depth.");
} // namespace lumbricus
