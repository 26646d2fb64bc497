// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_run_h
#define lumbricus_program_run_h

#include <lumbricus/program/command_line.h>

#include <deal.II/base/mpi.h>

#include <exception>

namespace lumbricus
{
  /** What the program ends with. */
  struct ExitCode
  {
    static constexpr int done         = 0; ///< nothing went wrong
    static constexpr int wrong_input  = 1; ///< ExcInput
    static constexpr int solve_failed = 2; ///< ExcSolveFailed
    static constexpr int bug          = 3; ///< anything else
    static constexpr int interrupted  = 4; ///< ExcInterrupted
  };

  /**
   * Read and validate the input, make the mesh and, unless only a check is
   * asked for, compute the run and write its results. Throws ExcInput,
   * ExcSolveFailed and ExcInterrupted. Collective.
   */
  void
  run(const CommandLine &command_line, const MPI_Comm comm);

  /** Say what was thrown and end all ranks; that memory has ended is no bug. */
  void
  abort_on_bug(const std::exception &exception, const MPI_Comm comm);
} // namespace lumbricus

#endif
