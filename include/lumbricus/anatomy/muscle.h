// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_anatomy_muscle_h
#define lumbricus_anatomy_muscle_h

#include <lumbricus/action/muscle_action.h>
#include <lumbricus/core/load_curve.h>
#include <lumbricus/core/load_time.h>
#include <lumbricus/fibres/fibre_field.h>
#include <lumbricus/geometry/part_of_body.h>
#include <lumbricus/parameters/registry.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /** A muscle: a family of fibres, and what it does along them over time. */
  class Muscle : public PartOfBody
  {
  public:
    /** The muscle of the section Muscles/@p name. */
    explicit Muscle(const std::string &name);

    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    bool
    extend_parameters(dealii::ParameterHandler &prm,
                      const Extent              extent) override;

    void
    check_parameters() const override;

    /** Those of fibres and action. */
    void
    initialize(const std::string &section, const Geometry &geometry) override;

    /** The name of its section, as tissues name it. */
    const std::string &
    name() const;

    /** The name in those of fields: blanks are '_'. */
    std::string
    field_name() const;

    /** The name of the field of its activation: "active_stretch_" and
     * field_name(). */
    std::string
    activation_field_name() const;

    /** What it does to the tissues in which its fibres run. */
    const MuscleAction &
    action() const;

    /** The name of its FibreField, as users choose it. */
    const std::string &
    fibres_name() const;

    /** The name of its MuscleAction, as users choose it. */
    const std::string &
    action_name() const;

    /**
     * The unit vector along the fibres at @p X. Throws ExcInput where they
     * have no direction, naming muscle and point.
     */
    dealii::Tensor<1, dim>
    fibre_direction(const dealii::Point<dim> &X) const;

    /** The fibre at @p X in segment @p segment (from one) at rest. Throws
     * ExcInput where there is no direction or no tension, naming the muscle. */
    MuscleFibre
    fibre_at_rest(const unsigned int        segment,
                  const dealii::Point<dim> &X) const;

    /** The direction of its fibres, whose exceptions do not name the muscle. */
    const FibreField &
    fibres() const
    {
      return *fibre_choice;
    }

    /**
     * Its activation, which is its active stretch where its action is that, at
     * time @p t in segment @p segment (from one) at reference position @p X.
     * Throws ExcInput where it is not what MuscleAction::requirement() says,
     * naming muscle, segment and time.
     */
    double
    activation(const LoadTime           &t,
               const unsigned int        segment,
               const dealii::Point<dim> &X) const;

    /** The activation in segment @p segment over time, at some points of it, as
     * it is: MuscleAction::requirement() is not asked. */
    LoadCurve
    load_curve(const unsigned int                     segment,
               const std::vector<dealii::Point<dim>> &points) const;

  private:
    /** What @p function returns; an ExcInput that it throws gets the name of the
     * muscle. */
    template <typename Function>
    auto
    name_in_message(const Function &function) const;

    double
    activation_at(const double              t,
                  const unsigned int        segment,
                  const dealii::Point<dim> &X) const;

    const std::string    muscle_name;
    Choice<FibreField>   fibre_choice;
    Choice<MuscleAction> action_choice;
  };
} // namespace lumbricus

#endif
