// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/linear/kept_preconditioner.h>
#include <lumbricus/parameters/registry.h>

#include "factor_kinds.h"

namespace lumbricus
{
  /** A kept factorisation, a more robust one where the fastest does not do. */
  class KeptFactor : public KeptPreconditioner
  {
    InverseKind
    make(const Tangent &tangent, const unsigned int kind) override
    {
      return make_factors(tangent, kind);
    }
  };

  static const Register<LinearSolver, KeptFactor>
    kept_factor("kept factor",
                "MUMPS in single precision, the factors kept as preconditioner "
                "of FGMRES for as long as they are worth it.");
} // namespace lumbricus
