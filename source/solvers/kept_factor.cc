// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/registry.h>
#include <lumbricus/solvers/condensed_factor.h>
#include <lumbricus/solvers/kept_preconditioner.h>

namespace lumbricus
{
  /** A kept factorisation of the condensed tangent, with pivoting where that
   * without does not do. */
  class KeptFactor : public KeptPreconditioner
  {
    Kind
    make(const Tangent &tangent, const unsigned int kind) override
    {
      if (kind > 1)
        return {};
      const bool pivoting = kind == 1;
      return {CondensedFactor::name(pivoting),
              std::make_unique<CondensedFactor>(tangent,
                                                pivoting,
                                                tangent.space.communicator())};
    }
  };

  static const Register<LinearSolver, KeptFactor>
    kept_factor("kept factor",
                "MUMPS in single precision, the factors kept as preconditioner "
                "of FGMRES for as long as they are worth it.");
} // namespace lumbricus
