// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_out_of_memory_h
#define lumbricus_core_out_of_memory_h

#include <lumbricus/core/exceptions.h>

#include <deal.II/base/mpi.h>

#include <exception>
#include <string>

namespace lumbricus
{
  /** Whether @p exception says that memory could not be allocated: a
   * std::bad_alloc or deal.II's ExcOutOfMemory. */
  bool
  is_out_of_memory(const std::exception &exception);

  /** How many bytes were asked for; 0 where @p exception does not say. */
  double
  bytes_asked_for(const std::exception &exception);

  /**
   * Sentences that say that memory ended on @p rank of @p comm, which asked for
   * @p bytes more (0: that is not known), and what to do.
   */
  std::string
  out_of_memory_message(const double       bytes,
                        const unsigned int rank,
                        const MPI_Comm     comm);

  /** What this rank uses and what limit it has, a sentence. */
  std::string
  memory_in_use();

  /**
   * Run @p body. Where memory ends in it and there is one rank only, this is an
   * ExcSolveFailed as any other; the memory that body took is free again. With
   * more ranks the exception passes: the others know nothing of it.
   */
  template <typename Body>
  void
  with_memory_message(const MPI_Comm comm, const Body &body)
  {
    std::string message;
    try
      {
        body();
      }
    catch (const std::exception &exception)
      {
        if (!is_out_of_memory(exception) ||
            dealii::Utilities::MPI::n_mpi_processes(comm) > 1)
          throw;
        message = out_of_memory_message(bytes_asked_for(exception), 0, comm) +
                  " " + memory_in_use();
      }
    AssertThrow(message.empty(), ExcSolveFailed(message));
  }
} // namespace lumbricus

#endif
