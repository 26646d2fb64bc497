// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_run_log_h
#define lumbricus_program_run_log_h

#include <lumbricus/core/log.h>
#include <lumbricus/output/run_costs.h>
#include <lumbricus/output/step_record.h>

namespace lumbricus
{
  /** The titles of what log_step() writes. */
  void
  log_header(Log &log);

  /** A line for a load step that has converged. */
  void
  log_step(Log &log, const StepRecord &step, const double end_time);

  /** A line for an adaptation of the mesh. */
  void
  log_adaptation(Log &log, const AdaptationRecord &record);

  /** Write a line with the largest estimated errors of @p step, where there are
   * any. */
  void
  log_errors(Log &log, const StepRecord &step);

  /** The table of where the time went, and the largest rank's peak memory. */
  void
  log_costs(Log &log, const RunCosts &costs);
} // namespace lumbricus

#endif
