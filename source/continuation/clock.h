// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_continuation_clock_h
#define lumbricus_continuation_clock_h

#include <lumbricus/program/chain_model.h>

namespace lumbricus
{
  /** Where the time is an unknown it only counts the loads. Throws ExcInput where
   * something of @p model depends on how fast it goes, or on the way to where it
   * is; or a prescribed displacement changes. Collective. */
  void
  check_needs_no_clock(const ChainModel &model);
} // namespace lumbricus

#endif
