// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/linear/kept_preconditioner.h>
#include <lumbricus/multigrid/v_cycle.h>
#include <lumbricus/parameters/registry.h>

namespace lumbricus
{
  /** A kept cycle of multigrid. */
  class Multigrid : public KeptPreconditioner
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      KeptPreconditioner::declare_parameters(prm);
      parameters.declare_parameters(prm);
    }

  private:
    InverseKind
    make(const Tangent &tangent, const unsigned int kind) override
    {
      if (kind > 0)
        return {};
      return {VCycle::name, std::make_unique<VCycle>(tangent, parameters)};
    }

    VCycleParameters parameters;
  };

  static const Register<LinearSolver, Multigrid>
    multigrid("multigrid",
              "A cycle of geometric multigrid as preconditioner of FGMRES: "
              "cells as patches of the smoother, MUMPS on a coarse mesh. For "
              "meshes that were refined.");
} // namespace lumbricus
