// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_action_tension_h
#define lumbricus_action_tension_h

#include <lumbricus/action/muscle_action.h>
#include <lumbricus/action/tension_curve.h>
#include <lumbricus/geometry/segment_expression.h>
#include <lumbricus/parameters/registry.h>

#include <string>

namespace lumbricus
{
  /**
   * The tension g of a fibre, force per area at rest, at its stretch l = |F f|
   * and the rate v = (l - l_n)/dt with the l_n of the last load step,
   *
   *   g = alpha T0 f_l(l) f_v(v)          of the kind 'nominal',
   *   g = alpha T0 f_l(l) f_v(v) l        of the kind 'second Piola',
   *
   * with the activation alpha and the strength T0.
   */
  class Tension : public PartOfBody
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    bool
    extend_parameters(dealii::ParameterHandler &prm,
                      const Extent              extent) override;

    void
    check_parameters() const override;

    void
    initialize(const std::string &section, const Geometry &geometry) override;

    /** T0 at @p X of segment @p segment, from zero [N/mm^2]. Throws ExcInput
     * where that is no number >= 0. */
    double
    strength(const unsigned int segment, const dealii::Point<dim> &X) const;

    /** Whether f_v is anything but 1. */
    bool
    feels_speed() const;

    /** g and dg/dl [N/mm^2] of @p fibre at the stretch @p l. */
    CurvePoint
    at(const MuscleFibre &fibre, const double l) const;

  private:
    std::string           kind             = "nominal";
    SegmentExpression     strength_formula = {"Strength", "0.1"};
    Choice<ForceLength>   force_length     = {
      "Force-length",
      "none",
      "Which part of its tension a fibre has at the stretch l."};
    Choice<ForceVelocity> force_velocity = {
      "Force-velocity",
      "none",
      "Which part of its tension a fibre has while its length changes."};

    std::string path; ///< that of the section and '/'
  };
} // namespace lumbricus

#endif
