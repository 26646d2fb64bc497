// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_interruption_h
#define lumbricus_core_interruption_h

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <string>

namespace lumbricus
{
  /**
   * Somebody wants the run to end: SIGTERM, as batch systems send it, SIGINT
   * (Ctrl-C), SIGHUP (the terminal is closed) or SIGUSR1, which mpirun passes
   * on; or nobody reads what it says any more. The state is written, exit code
   * 4.
   */
  DeclException1(ExcInterrupted, std::string, << arg1);

  /** Note which of these signals are ignored now, as when the program was
   * started with nohup. Without a call that is what they are when
   * watch_for_interruption() is called first. */
  void
  note_ignored_signals();

  /**
   * Take note of these signals from now on instead of ending; a second one
   * ends the process, unless it comes within a second of the first: terminals,
   * batch systems and mpirun send several at once. Those that
   * note_ignored_signals() has found are ignored. To be called first of all,
   * and again when libraries have been started, which may install what they
   * like.
   */
  void
  watch_for_interruption();

  /** Do not end where what is written to is closed (SIGPIPE). */
  void
  ignore_closed_output();

  /** Whether one of these signals, or a closed output, was noted here: a rank
   * may know it before others do. */
  bool
  is_interrupted();

  /** Take note that nobody reads the standard output any more. */
  void
  note_closed_output();

  /**
   * Throw ExcInterrupted on all ranks where any has got a signal. A safe point:
   * nothing may be half done. Collective.
   */
  void
  throw_if_interrupted(const MPI_Comm comm);



  /** While one of these lives there is no safe point. */
  class Uninterrupted
  {
  public:
    /** From here on throw_if_interrupted() does nothing. */
    Uninterrupted();
    /** Up to here, where this is the only one. */
    ~Uninterrupted();

    Uninterrupted(const Uninterrupted &) = delete;
    Uninterrupted &
    operator=(const Uninterrupted &) = delete;
  };
} // namespace lumbricus

#endif
