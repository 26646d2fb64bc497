// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_equilibrium_unknowns_h
#define lumbricus_equilibrium_unknowns_h

#include <lumbricus/core/state.h>

#include <cstddef>

namespace lumbricus
{
  /** What Newton's method solves for, or an increment of it: a value. */
  struct Unknowns
  {
    Vector  solution; ///< as State::solution
    Globals globals;  ///< as State::globals; empty where there are none

    /** Add @p part times @p increment, which has the unknowns among the globals:
     * others are remembered. */
    void
    add(const double part, const Unknowns &increment)
    {
      solution.add(part, increment.solution);
      for (const auto &[name, changes] : increment.globals)
        for (std::size_t k = 0; k < changes.size(); ++k)
          globals.at(name)[k] += part * changes[k];
    }
  };
} // namespace lumbricus

#endif
