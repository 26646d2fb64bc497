// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/registry.h>
#include <lumbricus/multigrid/v_cycle.h>
#include <lumbricus/solvers/kept_preconditioner.h>

namespace lumbricus
{
  /** A kept V-cycle. */
  class Multigrid : public KeptPreconditioner<VCycle>
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      KeptPreconditioner<VCycle>::declare_parameters(prm);
      parameters.declare_parameters(prm);
    }

  private:
    std::unique_ptr<VCycle>
    make_inverse(const Tangent &tangent) const override
    {
      return std::make_unique<VCycle>(tangent, parameters);
    }

    VCycleParameters parameters;
  };

  static const Register<LinearSolver, Multigrid>
    multigrid("multigrid",
              "A cycle of geometric multigrid as preconditioner of FGMRES: "
              "cells as patches of the smoother, MUMPS on a coarse mesh. For "
              "meshes that were refined, beyond about 100,000 unknowns.");
} // namespace lumbricus
