// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_diagnosis_h
#define lumbricus_program_diagnosis_h

#include <lumbricus/program/chain_model.h>

#include <string>

namespace lumbricus
{
  /**
   * In words, why no load step leads on from @p state, which is in equilibrium:
   * a limit point of the loads, a bifurcation (buckling), or, where the body is
   * stable, cells that have lost their shape or something else. Loads are those
   * that act after another @p step of time. Collective.
   */
  std::string
  diagnose(ChainModel &model, const State &state, const double step);
} // namespace lumbricus

#endif
