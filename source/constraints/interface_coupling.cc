// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/constraints/interface_coupling.h>

#include <deal.II/base/patterns.h>

namespace lumbricus
{
  void
  InterfaceCoupling::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Interface");
    prm.add_parameter(
      "Coupling",
      coupling,
      "What liquid and wall share where they touch. 'tied': the displacement. "
      "'slip': the displacement along the normal of the deformed liquid, renewed "
      "with every load step and reset, so that no shear passes. 'reference "
      "slip': the displacement along the normal at rest, as in the paper; not "
      "stable under many resets.",
      dealii::Patterns::Selection("tied|slip|reference slip"));
    prm.leave_subsection();
  }



  bool
  InterfaceCoupling::slips() const
  {
    return coupling != "tied";
  }



  bool
  InterfaceCoupling::follows_the_deformation() const
  {
    return coupling == "slip";
  }
} // namespace lumbricus
