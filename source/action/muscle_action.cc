// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/action/muscle_action.h>

#include <cctype>

namespace lumbricus
{
  namespace
  {
    // "Active stretch" of "active stretch".
    std::string
    capitalised(std::string name)
    {
      name.front() = std::toupper(static_cast<unsigned char>(name.front()));
      return name;
    }
  } // namespace



  MuscleAction::MuscleAction(const std::string &quantity,
                             const double       at_rest,
                             const double       contracted,
                             const std::string &documentation)
    : quantity_name(quantity)
    , rest(at_rest)
    , activation_choice(capitalised(quantity),
                        "",
                        documentation,
                        Placement::own_section,
                        ": the muscle has no " + quantity)
  {
    activation_choice.prepare_with(
      [at_rest, contracted](Activation &activation) {
        activation.set_scale(at_rest, contracted);
      });
  }



  void
  MuscleAction::declare_parameters(dealii::ParameterHandler &prm)
  {
    activation_choice.declare_parameters(prm);
  }



  bool
  MuscleAction::extend_parameters(dealii::ParameterHandler &prm,
                                  const Extent              extent)
  {
    return activation_choice.extend_parameters(prm, extent);
  }



  void
  MuscleAction::check_parameters() const
  {
    activation_choice.check_parameters();
  }



  void
  MuscleAction::initialize(const std::string &section,
                           const Geometry    &geometry)
  {
    activation_choice.get()->initialize(activation_choice.section_in(section),
                                        geometry);
  }



  const std::string &
  MuscleAction::quantity() const
  {
    return quantity_name;
  }



  double
  MuscleAction::at_rest() const
  {
    return rest;
  }



  const Choice<Activation> &
  MuscleAction::activation() const
  {
    return activation_choice;
  }
} // namespace lumbricus
