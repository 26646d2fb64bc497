// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_locking_watch_h
#define lumbricus_program_locking_watch_h

#include <lumbricus/core/log.h>
#include <lumbricus/core/state.h>
#include <lumbricus/discretization/body.h>
#include <lumbricus/discretization/reference_field.h>

#include <set>

namespace lumbricus
{
  /** Looks after every load step whether a tissue is near the strain at which its
   * law locks, which is 0.9 of it. */
  class LockingWatch
  {
  public:
    /** Say so in @p log, once for every tissue, at @p state, which @p
     * references belong to. Collective. */
    void
    look(const Body           &body,
         const ReferenceField &references,
         const State          &state,
         Log                  &log);

  private:
    /** The numbers of tissues that have been named. */
    std::set<unsigned int> named;
  };
} // namespace lumbricus

#endif
