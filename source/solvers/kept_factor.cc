// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/registry.h>
#include <lumbricus/solvers/condensed_factor.h>
#include <lumbricus/solvers/kept_preconditioner.h>

namespace lumbricus
{
  /** A kept factorisation of the condensed tangent. */
  class KeptFactor : public KeptPreconditioner<CondensedFactor>
  {
    std::unique_ptr<CondensedFactor>
    make_inverse(const Tangent &tangent) const override
    {
      return std::make_unique<CondensedFactor>(tangent,
                                               tangent.space.communicator());
    }
  };

  static const Register<LinearSolver, KeptFactor>
    kept_factor("kept factor",
                "MUMPS in single precision, the factors kept as preconditioner "
                "of FGMRES for as long as they are worth it.");
} // namespace lumbricus
