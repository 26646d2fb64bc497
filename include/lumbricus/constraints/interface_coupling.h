// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_constraints_interface_coupling_h
#define lumbricus_constraints_interface_coupling_h

#include <lumbricus/parameters/parameter_owner.h>

#include <string>

namespace lumbricus
{
  /** How liquid and wall hold together where they touch. */
  class InterfaceCoupling : public ParameterOwner
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    /** Whether they share the normal displacement only. */
    bool
    slips() const;

    /** Whether the normals are those of the deformed liquid. */
    bool
    follows_the_deformation() const;

  private:
    std::string coupling = "tied";
  };
} // namespace lumbricus

#endif
