// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_mesh_adaptation_h
#define lumbricus_program_mesh_adaptation_h

#include <lumbricus/core/log.h>
#include <lumbricus/output/step_record.h>
#include <lumbricus/program/chain_model.h>

namespace lumbricus
{
  /**
   * One adaptation: estimate the error of @p state, refine and coarsen, take
   * the state along, and solve again at the same load. Where that does not
   * work, mesh and state are as they were before, and the log says so.
   * @param last the last solve for @p state.
   * @return what was done; its report is that of solving again. Collective.
   */
  AdaptationRecord
  adapt_mesh(ChainModel                  &model,
             State                       &state,
             const ResetIteration::Solve &last,
             Log                         &log);
} // namespace lumbricus

#endif
