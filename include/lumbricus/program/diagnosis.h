// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_diagnosis_h
#define lumbricus_program_diagnosis_h

#include <lumbricus/program/chain_model.h>

#include <string>

namespace lumbricus
{
  /**
   * In words, why no load step leads on from @p state, which is in equilibrium
   * with the loads of @p now, towards those of @p next: a limit point of the
   * loads, a bifurcation (buckling), or, where the body is stable, cells that
   * have lost their shape or something else. Collective.
   */
  std::string
  diagnose(ChainModel     &model,
           const State    &state,
           const LoadTime &now,
           const LoadTime &next);
} // namespace lumbricus

#endif
