// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/anatomy/muscle.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/parameters/expression.h>

#include <algorithm>
#include <sstream>

namespace lumbricus
{
  namespace
  {
    // As a part of the name of a field.
    std::string
    underscored(std::string name)
    {
      std::replace(name.begin(), name.end(), ' ', '_');
      return name;
    }
  } // namespace



  Muscle::Muscle(const std::string &name)
    : muscle_name(name)
    , fibre_choice("Fibres",
                   "",
                   "The direction of the fibres at rest.",
                   Placement::own_section,
                   ": the muscle '" + name + "' has no fibres")
    , action_choice("Action",
                    "active stretch",
                    "What the muscle does to the tissue. How much of it, at "
                    "what time, is chosen by the parameter of the same name.",
                    Placement::beside_entry)
  {}



  void
  Muscle::declare_parameters(dealii::ParameterHandler &prm)
  {
    fibre_choice.declare_parameters(prm);
    action_choice.declare_parameters(prm);
  }



  bool
  Muscle::extend_parameters(dealii::ParameterHandler &prm, const Extent extent)
  {
    const bool fibres = fibre_choice.extend_parameters(prm, extent);
    const bool action = action_choice.extend_parameters(prm, extent);
    return fibres || action;
  }



  void
  Muscle::check_parameters() const
  {
    fibre_choice.check_parameters();
    action_choice.check_parameters();
  }



  void
  Muscle::initialize(const std::string &section, const Geometry &geometry)
  {
    fibre_choice.get()->initialize(fibre_choice.section_in(section), geometry);
    action_choice.get()->initialize(action_choice.section_in(section),
                                    geometry);
  }



  const std::string &
  Muscle::name() const
  {
    return muscle_name;
  }



  std::string
  Muscle::field_name() const
  {
    return underscored(muscle_name);
  }



  std::string
  Muscle::activation_field_name() const
  {
    return underscored(action().quantity()) + "_" + field_name();
  }



  const MuscleAction &
  Muscle::action() const
  {
    return *action_choice;
  }



  const std::string &
  Muscle::fibres_name() const
  {
    return fibre_choice.chosen_name();
  }



  const std::string &
  Muscle::action_name() const
  {
    return action_choice.chosen_name();
  }



  template <typename Function>
  auto
  Muscle::name_in_message(const Function &function) const
  {
    decltype(function()) result{};
    try
      {
        result = function();
      }
    catch (const ExcInput &exception)
      {
        AssertThrow(false,
                    ExcInput("Muscle '" + muscle_name +
                             "': " + plain_message(exception)));
      }
    return result;
  }



  dealii::Tensor<1, dim>
  Muscle::fibre_direction(const dealii::Point<dim> &X) const
  {
    return name_in_message([&]() { return fibre_choice->direction(X); });
  }



  MuscleFibre
  Muscle::fibre_at_rest(const unsigned int        segment,
                        const dealii::Point<dim> &X) const
  {
    MuscleFibre fibre;
    fibre.f               = fibre_direction(X);
    fibre.activation      = action().at_rest();
    fibre.largest_tension = name_in_message(
      [&]() { return action().largest_tension(segment - 1, X); });
    return fibre;
  }



  double
  Muscle::activation(const LoadTime           &t,
                     const unsigned int        segment,
                     const dealii::Point<dim> &X) const
  {
    return t.take(
      [&](const double at) { return activation_at(at, segment, X); },
      action().at_rest());
  }



  LoadCurve
  Muscle::load_curve(const unsigned int                     segment,
                     const std::vector<dealii::Point<dim>> &points) const
  {
    const MuscleAction &action = this->action();
    LoadCurve           curve;
    curve.what =
      "the " + action.quantity() + " of muscle '" + muscle_name + "'";
    curve.where   = " in segment " + std::to_string(segment);
    curve.at_rest = action.at_rest();
    for (const dealii::Point<dim> &X : points)
      curve.values.push_back([&action, segment, X](const double t) {
        return action.activation()->value(t, segment, X);
      });
    curve.marks = [&action, segment](const double from, const double to) {
      return action.activation()->marks(segment, from, to);
    };
    return curve;
  }



  double
  Muscle::activation_at(const double              t,
                        const unsigned int        segment,
                        const dealii::Point<dim> &X) const
  {
    const MuscleAction &action      = this->action();
    const double        value       = action.activation()->value(t, segment, X);
    const std::string   requirement = action.requirement(value);
    if (!requirement.empty())
      {
        std::ostringstream message;
        message << "The " << action.quantity() << " of muscle '" << muscle_name
                << "' in segment " << segment << " at time " << t
                << ", X = " << point_text(X) << ", is " << value
                << "; it has to be " << requirement << ". Change 'Muscles/"
                << muscle_name << "/" << action.activation().chosen_name()
                << "'.";
        AssertThrow(false, ExcInput(message.str()));
      }
    return value;
  }
} // namespace lumbricus
