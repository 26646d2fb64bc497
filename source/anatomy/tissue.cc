// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/anatomy/tissue.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/materials/flowing_liquid.h>
#include <lumbricus/parameters/patterns.h>

#include <cstddef>

namespace lumbricus
{
  Tissue::Tissue(const std::string &name)
    : tissue_name(name)
    , law_choice("Law",
                 "Neo-Hooke",
                 "The constitutive law. In a liquid with a wall around it, it "
                 "has by default a thousandth of the stiffness given here.")
  {}



  void
  Tissue::make_liquid()
  {
    law_choice.prepare_with(
      [](MaterialLaw &law) { law.scale_stiffness(1. / 1000.); });
  }



  void
  Tissue::declare_parameters(dealii::ParameterHandler &prm)
  {
    law_choice.declare_parameters(prm);
    prm.add_parameter("Density",
                      mass_density,
                      "[t/mm^3] Mass per volume at rest, for a body force that "
                      "is a weight. Water has 1e-9.",
                      dealii::Patterns::Double(0.));
    prm.add_parameter("Muscles",
                      names_of_muscles,
                      "The muscles whose fibres run in this tissue, each a "
                      "section in Muscles; empty for a passive tissue.",
                      NameList());
  }



  bool
  Tissue::extend_parameters(dealii::ParameterHandler &prm, const Extent extent)
  {
    return law_choice.extend_parameters(prm, extent);
  }



  void
  Tissue::check_parameters() const
  {
    law_choice.check_parameters();
    check_no_name_twice("Muscles", names_of_muscles);
  }



  void
  Tissue::set_muscles(const std::vector<const Muscle *> &muscles)
  {
    chosen_law  = &law();
    its_muscles = muscles;
    actions.clear();
    for (const Muscle *muscle : its_muscles)
      actions.push_back(&muscle->action());
  }



  const std::string &
  Tissue::name() const
  {
    return tissue_name;
  }



  const MaterialLaw &
  Tissue::law() const
  {
    return *law_choice;
  }



  const std::string &
  Tissue::law_name() const
  {
    return law_choice.chosen_name();
  }



  std::string
  Tissue::law_section() const
  {
    return law_choice.section_in("Tissues/" + tissue_name);
  }



  const std::vector<std::string> &
  Tissue::muscle_names() const
  {
    return names_of_muscles;
  }



  const std::vector<const Muscle *> &
  Tissue::muscles() const
  {
    return its_muscles;
  }



  ReferencePoint
  Tissue::reference_map(const std::vector<MuscleFibre> &fibres) const
  {
    AssertDimension(fibres.size(), actions.size());
    std::vector<ActiveFibre> stretches;
    stretches.reserve(fibres.size());
    for (std::size_t k = 0; k < actions.size(); ++k)
      actions[k]->add_stretch(fibres[k], stretches);
    return active_stretch_map(stretches);
  }



  void
  Tissue::evaluate(const dealii::Tensor<2, dim> &F,
                   const double                  p,
                   const MaterialPoint          &point,
                   const bool                    with_tangent,
                   MaterialResponse             &response) const
  {
    AssertDimension(point.fibres.size(), actions.size());
    response.mu_missing = 0.;
    if (point.reference.flows)
      flowing_response(
        *chosen_law, F, p, point.reference.J_v, with_tangent, response);
    else
      chosen_law->evaluate(F, p, point.reference, with_tangent, response);
    for (std::size_t k = 0; k < actions.size(); ++k)
      actions[k]->add_stress(F, point.fibres[k], with_tangent, response);
  }
} // namespace lumbricus
