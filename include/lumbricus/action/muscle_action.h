// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_action_muscle_action_h
#define lumbricus_action_muscle_action_h

#include <lumbricus/activation/activation.h>
#include <lumbricus/geometry/part_of_body.h>
#include <lumbricus/materials/material_law.h>
#include <lumbricus/parameters/registry.h>
#include <lumbricus/reference_map/active_stretch.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /** A muscle at a point: the unit vector f along its fibres, and how active it
   * is. */
  struct MuscleFibre
  {
    dealii::Tensor<1, dim> f; ///< at rest
    double activation;        ///< as MuscleAction::quantity() says
    /** MuscleAction::largest_tension() there [N/mm^2]. */
    double largest_tension = 0.;
    /** |F f| at the end of the last load step, where MuscleAction::feels_speed().
     */
    double stretch_before = 1.;
    /** How long ago that was [time]; 0 where nothing moves. */
    double since = 0.;
  };



  /**
   * What a muscle does to the tissue in which its fibres run, as a function of
   * its activation: the law's response is that at the reference map of all
   * add_stretch(), and to it come the stresses of all add_stress(). Its
   * parameters are in the section of the muscle.
   */
  class MuscleAction : public PartOfBody
  {
  public:
    /** Declares which Activation there is, named after the quantity. */
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    bool
    extend_parameters(dealii::ParameterHandler &prm,
                      const Extent              extent) override;

    void
    check_parameters() const override;

    /** That of the activation. */
    void
    initialize(const std::string &section, const Geometry &geometry) override;

    /** What the activation is, for messages: "active stretch". */
    const std::string &
    quantity() const;

    /** The activation of a muscle at rest. */
    double
    at_rest() const;

    /** The activation over time. */
    const Choice<Activation> &
    activation() const;

    /** What the activation has to be, "a number > 0 (...)", where @p value is
     * not that; empty where it is. */
    virtual std::string
    requirement(const double value) const = 0;

    /**
     * How strongly a muscle of the activation @p value and of the
     * largest_tension() @p tension [N/mm^2] acts, zero at rest. Muscles of the
     * same action whose fibres cross are symmetric together where these are the
     * same.
     */
    virtual double
    strength(const double value, const double tension) const = 0;

    /** The tension that is the scale of that of the muscle at @p X, at rest, of
     * segment @p segment, from zero [N/mm^2]. Throws ExcInput. */
    virtual double
    largest_tension(const unsigned int /*segment*/,
                    const dealii::Point<dim> & /*X*/) const
    {
      return 0.;
    }

    /** Whether add_stress() asks for MuscleFibre::stretch_before: a run then
     * remembers where the body was (see displacement_before). */
    virtual bool
    feels_speed() const
    {
      return false;
    }

    /** Add to @p stretches, see active_stretch_map(), those that @p fibre makes
     * of the stress-free shape. */
    virtual void
    add_stretch(const MuscleFibre & /*fibre*/,
                std::vector<ActiveFibre> & /*stretches*/) const
    {}

    /**
     * Add the stress of @p fibre to P [N/mm^2] and, where @p with_tangent, its
     * derivative by F to A, which has to stay symmetric: that of a stress along
     * the fibre that depends on |F f| is, and on what that was before. Called at
     * every quadrature point.
     */
    virtual void
    add_stress(const dealii::Tensor<2, dim> & /*F*/,
               const MuscleFibre & /*fibre*/,
               const bool /*with_tangent*/,
               MaterialResponse & /*response*/) const
    {}

  protected:
    /** The parameter that chooses the activation has the name @p quantity, with
     * a capital, and @p documentation. Its value is @p contracted where a muscle
     * contracts as much as one can, see Activation::set_scale(). */
    MuscleAction(const std::string &quantity,
                 const double       at_rest,
                 const double       contracted,
                 const std::string &documentation);

  private:
    const std::string  quantity_name;
    const double       rest;
    Choice<Activation> activation_choice;
  };
} // namespace lumbricus

#endif
