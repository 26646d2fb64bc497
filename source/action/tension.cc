// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tension.h"

#include <lumbricus/core/exceptions.h>
#include <lumbricus/parameters/expression.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <cmath>

namespace lumbricus
{
  void
  Tension::declare_parameters(dealii::ParameterHandler &prm)
  {
    strength_formula.declare_parameter(
      prm,
      "[N/mm^2] The tension of a fibre whose activation is 1, force per area at "
      "rest: at least 0. A formula in the place x, y, z at rest and in the number "
      "s of the segment and the number n of segments.");
    prm.add_parameter("Kind",
                      kind,
                      "[nominal or second Piola] 'nominal': the force along a "
                      "fibre is what the curves below say. 'second Piola': that "
                      "times the stretch of the fibre, so that the second "
                      "Piola-Kirchhoff stress along it is what they say.",
                      dealii::Patterns::Selection("nominal|second Piola"));
    force_length.declare_parameters(prm);
    force_velocity.declare_parameters(prm);
  }



  bool
  Tension::extend_parameters(dealii::ParameterHandler &prm, const Extent extent)
  {
    const bool length   = force_length.extend_parameters(prm, extent);
    const bool velocity = force_velocity.extend_parameters(prm, extent);
    return length || velocity;
  }



  void
  Tension::check_parameters() const
  {
    AssertThrow(!strength_formula.depends_on_time(),
                ExcParameter(strength_formula.parameter(),
                             "is '" + strength_formula.text() +
                               "', but does not change with time. What does is "
                               "the activation."));
    force_length.check_parameters();
    force_velocity.check_parameters();
  }



  void
  Tension::initialize(const std::string &section, const Geometry &geometry)
  {
    path = section + "/";
    strength_formula.initialize(geometry);
    force_length.get()->initialize(force_length.section_in(section), geometry);
    force_velocity.get()->initialize(force_velocity.section_in(section),
                                     geometry);
  }



  double
  Tension::strength(const unsigned int segment, const dealii::Point<dim> &X) const
  {
    const double T0 = strength_formula.of(segment).value(X, 0.);
    AssertThrow(T0 >= 0. && std::isfinite(T0),
                ExcInput(about_parameter(
                  path + strength_formula.parameter(),
                  "is " + dealii::Utilities::to_string(T0) + " N/mm^2 at " +
                    point_text(X) + " in segment " +
                    std::to_string(segment + 1) +
                    ", but has to be a number >= 0. A muscle pulls.")));
    return T0;
  }



  bool
  Tension::feels_speed() const
  {
    return force_velocity->feels_speed();
  }



  CurvePoint
  Tension::at(const MuscleFibre &fibre, const double l) const
  {
    const double     T      = fibre.activation * fibre.largest_tension;
    const CurvePoint length = force_length->at(l);
    CurvePoint       g{T * length.value, T * length.slope};
    if (fibre.since > 0. && force_velocity->feels_speed())
      {
        const CurvePoint speed =
          force_velocity->at((l - fibre.stretch_before) / fibre.since);
        g.slope = g.slope * speed.value + g.value * speed.slope / fibre.since;
        g.value *= speed.value;
      }
    if (kind == "second Piola")
      {
        g.slope = g.slope * l + g.value;
        g.value *= l;
      }
    return g;
  }
} // namespace lumbricus
