// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_run_h
#define lumbricus_program_run_h

#include <lumbricus/program/command_line.h>

#include <deal.II/base/mpi.h>

namespace lumbricus
{
  /**
   * Read and validate the input, make the mesh and, unless only a check is
   * asked for, compute the run and write its results. Throws ExcInput and
   * ExcSolveFailed. Collective.
   */
  void
  run(const CommandLine &command_line, const MPI_Comm comm);
} // namespace lumbricus

#endif
