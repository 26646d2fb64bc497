// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/available_memory.h>
#include <lumbricus/linear/kept_preconditioner.h>
#include <lumbricus/multigrid/v_cycle.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/registry.h>

#include <sstream>

#include "condensed_factor.h"
#include "factor_kinds.h"

namespace lumbricus
{
  /**
   * A kept factorisation, or a kept cycle of multigrid where the analysis of
   * the matrix says that factors would take too much memory or work. Where
   * multigrid does not do, factors follow.
   */
  class Automatic : public KeptPreconditioner
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      KeptPreconditioner::declare_parameters(prm);
      prm.add_parameter("Most memory",
                        most_memory,
                        "[-] Factors may take this part of the memory that is "
                        "available.",
                        dealii::Patterns::Double(0.));
      prm.add_parameter("Most work",
                        most_work,
                        "[operations] Factors may take this many operations "
                        "per unknown.",
                        dealii::Patterns::Double(0.));
      prm.enter_subsection("multigrid");
      multigrid.declare_parameters(prm);
      prm.leave_subsection();
    }

  private:
    InverseKind
    make(const Tangent &tangent, const unsigned int kind) override
    {
      const auto n = tangent.space.dof_handler.n_dofs();
      if (n != n_decided)
        {
          // Decided once all of it is known: planning may run out of memory.
          const MPI_Comm comm = tangent.space.communicator();
          const auto    &fast = CondensedFactor::accuracies[0];
          auto planned = std::make_unique<CondensedFactor>(tangent, fast, comm);
          by_multigrid = tangent.space.triangulation.n_global_levels() > 1 &&
                         too_much(*planned, n, comm);
          n_decided = n;
          if (!by_multigrid)
            return {fast.name, std::move(planned)};
        }
      if (by_multigrid && kind == 0)
        return {VCycle::name, std::make_unique<VCycle>(tangent, multigrid)};
      return make_factors(tangent, by_multigrid ? kind - 1 : kind);
    }

    /** Decide, and say so. */
    bool
    too_much(CondensedFactor                      &factors,
             const dealii::types::global_dof_index n,
             const MPI_Comm                        comm)
    {
      const double work      = factors.planned_flops() / n;
      const double available = available_megabytes(comm);
      if (work <= most_work &&
          factors.planned_megabytes() <= most_memory * available)
        return false;
      std::ostringstream message;
      message.precision(2);
      message << "Linear systems are solved by multigrid: factors would take "
              << work << " operations per unknown and "
              << factors.planned_megabytes() / 1024. << " GB a rank, of "
              << available / 1024. << " GB available.";
      tell(message.str());
      return true;
    }

    double                          most_memory = 0.6;
    double                          most_work   = 5e7;
    VCycleParameters                multigrid;
    dealii::types::global_dof_index n_decided    = 0;
    bool                            by_multigrid = false;
  };

  static const Register<LinearSolver, Automatic>
    automatic("auto",
              "'kept factor' or, where factors would take too much memory or "
              "work, 'multigrid'; if that fails, factors all the same.");
} // namespace lumbricus
