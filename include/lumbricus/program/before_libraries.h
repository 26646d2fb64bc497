// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_before_libraries_h
#define lumbricus_program_before_libraries_h

#include <lumbricus/core/interruption.h>

namespace lumbricus
{
  /**
   * To be included by the file with main(), and by no other: the program notes
   * which signals are ignored (nohup) before any library is initialised. UCX,
   * which comes with Open MPI 5, takes SIGHUP for its own when it is loaded.
   */
  [[gnu::used, gnu::section(".preinit_array")]] static void (
    *const before_libraries)() = &note_ignored_signals;
} // namespace lumbricus

#endif
