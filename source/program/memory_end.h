// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_memory_end_h
#define lumbricus_program_memory_end_h

#include <deal.II/base/mpi.h>

#include <exception>

namespace lumbricus
{
  /**
   * Where memory ends on one of several ranks the others wait for it, and to
   * unwind would wait for them: from now on such a rank says so and ends all of
   * them at once, with the exit code of a run that cannot go on; the last
   * checkpoint stays. A single rank gets std::bad_alloc as ever.
   */
  void
  end_all_ranks_when_memory_ends(const MPI_Comm comm);

  /**
   * Let the BLAS take the memory it works in now, while there is some: OpenBLAS,
   * which takes it at the first call and keeps it, waits for ever where it gets
   * none. Throws std::bad_alloc where there is not enough.
   */
  void
  reserve_blas_memory();

  /** Say on this rank that memory has ended, as @p exception says, and end all
   * ranks. */
  [[noreturn]] void
  abort_out_of_memory(const std::exception &exception, const MPI_Comm comm);
} // namespace lumbricus

#endif
