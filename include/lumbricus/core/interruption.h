// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_interruption_h
#define lumbricus_core_interruption_h

#include <deal.II/base/exceptions.h>
#include <deal.II/base/mpi.h>

#include <string>

namespace lumbricus
{
  /**
   * Somebody wants the run to end: SIGTERM, as batch systems send it, or
   * SIGUSR1, which mpirun passes on. The state is written, exit code 4.
   */
  DeclException1(ExcInterrupted, std::string, << arg1);

  /** Take note of SIGTERM and SIGUSR1 from now on instead of ending. */
  void
  watch_for_interruption();

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
