// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/anatomy/tissue.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/patterns.h>

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
    prm.add_parameter("Muscles",
                      muscle_names,
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
    check_no_name_twice("Muscles", muscle_names);
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
    return "Tissues/" + tissue_name + "/" + law_name();
  }



  const std::vector<std::string> &
  Tissue::muscles() const
  {
    return muscle_names;
  }
} // namespace lumbricus
