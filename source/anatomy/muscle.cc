// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/anatomy/muscle.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/expression.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace lumbricus
{
  Muscle::Muscle(const std::string &name)
    : muscle_name(name)
    , fibre_choice("Fibres", "", "The direction of the fibres at rest.")
    , activation_choice("Active stretch",
                        "",
                        "How the stress-free length of the fibres, relative "
                        "to their length at rest, changes with time.")
  {}



  void
  Muscle::declare_parameters(dealii::ParameterHandler &prm)
  {
    fibre_choice.declare_parameters(prm);
    activation_choice.declare_parameters(prm);
  }



  bool
  Muscle::extend_parameters(dealii::ParameterHandler &prm, const Extent extent)
  {
    const bool fibres     = fibre_choice.extend_parameters(prm, extent);
    const bool activation = activation_choice.extend_parameters(prm, extent);
    return fibres || activation;
  }



  void
  Muscle::check_parameters() const
  {
    AssertThrow(fibre_choice.get() != nullptr,
                ExcParameter("Fibres",
                             "is not set: the muscle '" + muscle_name +
                               "' has no fibres. Set it to one of " +
                               Registry<FibreField>::quoted_names() + "."));
    AssertThrow(activation_choice.get() != nullptr,
                ExcParameter("Active stretch",
                             "is not set: the muscle '" + muscle_name +
                               "' has no active stretch. Set it to one of " +
                               Registry<Activation>::quoted_names() + "."));
    fibre_choice.check_parameters();
    activation_choice.check_parameters();
  }



  void
  Muscle::initialize(const unsigned int n_segments)
  {
    fibre_choice.get()->initialize(muscle_name);
    activation_choice.get()->initialize(muscle_name, n_segments);
  }



  const std::string &
  Muscle::name() const
  {
    return muscle_name;
  }



  std::string
  Muscle::field_name() const
  {
    std::string name = muscle_name;
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
  }



  const std::string &
  Muscle::fibres_name() const
  {
    return fibre_choice.chosen_name();
  }



  const std::string &
  Muscle::active_stretch_name() const
  {
    return activation_choice.chosen_name();
  }



  dealii::Tensor<1, dim>
  Muscle::fibre_direction(const dealii::Point<dim> &X) const
  {
    try
      {
        return fibre_choice->direction(X);
      }
    catch (const ExcInput &exception)
      {
        AssertThrow(false,
                    ExcInput("Muscle '" + muscle_name +
                             "': " + plain_message(exception)));
      }
    return {};
  }



  bool
  Muscle::fibres_are_sampled() const
  {
    return fibre_choice->is_sampled();
  }



  double
  Muscle::active_stretch(const LoadTime           &t,
                         const unsigned int        segment,
                         const dealii::Point<dim> &X) const
  {
    return t.take(
      [&](const double at) { return active_stretch_at(at, segment, X); }, 1.);
  }



  LoadCurve
  Muscle::load_curve(const unsigned int                     segment,
                     const std::vector<dealii::Point<dim>> &points) const
  {
    LoadCurve curve;
    curve.what    = "the active stretch of muscle '" + muscle_name + "'";
    curve.where   = " in segment " + std::to_string(segment);
    curve.at_rest = 1.;
    for (const dealii::Point<dim> &X : points)
      curve.values.push_back([this, segment, X](const double t) {
        return activation_choice->value(t, segment, X);
      });
    curve.marks = [this, segment](const double from, const double to) {
      return activation_choice->marks(segment, from, to);
    };
    return curve;
  }



  double
  Muscle::active_stretch_at(const double              t,
                            const unsigned int        segment,
                            const dealii::Point<dim> &X) const
  {
    const double lambda = activation_choice->value(t, segment, X);
    if (!(lambda > 0. && std::isfinite(lambda)))
      {
        std::ostringstream message;
        message << "The active stretch of muscle '" << muscle_name
                << "' in segment " << segment << " at time " << t
                << ", X = " << point_text(X) << ", is " << lambda
                << "; it has to be a number > 0 (1 is rest, 0.8 a contraction "
                   "by 20%). Change 'Muscles/"
                << muscle_name << "/" << activation_choice.chosen_name()
                << "'.";
        AssertThrow(false, ExcInput(message.str()));
      }
    return lambda;
  }
} // namespace lumbricus
