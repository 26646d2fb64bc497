// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_reset_errors_h
#define lumbricus_program_reset_errors_h

#include <lumbricus/core/log.h>
#include <lumbricus/errors/segment_error.h>
#include <lumbricus/program/chain_model.h>

#include <vector>

namespace lumbricus
{
  /**
   * What more resets would add to the numbers of all segments at @p state, before
   * ChainModel::end_step(), for which @p model has found @p solve. All liquid is
   * reset twice more. A number J_0 becomes J_1 and J_2, and the largest change of a
   * number in any segment gets smaller by the factor q, as it will with all resets
   * that would follow:
   *
   *   e = J_2 - J_0 + (J_2 - J_1) q / (1 - q),
   *
   * without the last part where changes do not get smaller, since they are what
   * Newton's method leaves. 0 where liquid flows; NaN, with a word in @p log, where
   * there is no solution. Leaves the model at @p state. Collective.
   */
  std::vector<SegmentError>
  errors_of_resets(ChainModel                  &model,
                   const State                 &state,
                   const ResetIteration::Solve &solve,
                   Log                         &log);
} // namespace lumbricus

#endif
