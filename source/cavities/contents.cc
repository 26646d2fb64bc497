// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/cavities/contents.h>

namespace lumbricus
{
  namespace
  {
    constexpr const char *section = "Cavities";
  }



  CavityContents::CavityContents()
    : content("Content",
              "liquid",
              "What is in the chambers that have no cells inside.")
  {}



  void
  CavityContents::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection(section);
    content.declare_parameters(prm);
    prm.leave_subsection();
  }



  bool
  CavityContents::extend_parameters(dealii::ParameterHandler &prm,
                                    const Extent              extent)
  {
    prm.enter_subsection(section);
    const bool extended = content.extend_parameters(prm, extent);
    prm.leave_subsection();
    return extended;
  }



  void
  CavityContents::check_parameters() const
  {
    within_section(section, [&]() { content.check_parameters(); });
  }



  CavityEquation
  CavityContents::equation(const CavityPoint &point) const
  {
    return content->equation(point);
  }
} // namespace lumbricus
