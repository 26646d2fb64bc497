// SPDX-License-Identifier: LGPL-2.1-or-later
#include "memory_end.h"

#include <lumbricus/core/out_of_memory.h>
#include <lumbricus/program/run.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/identity_matrix.h>

#include <sys/mman.h>

#include <cstdlib>
#include <iostream>
#include <new>
#include <vector>

namespace lumbricus
{
  namespace
  {
    MPI_Comm all_ranks = MPI_COMM_NULL;

    // To say that there is no memory takes some.
    std::vector<char> reserve;



    [[noreturn]] void
    end_all_ranks(const double bytes, const MPI_Comm comm)
    {
      std::set_new_handler(nullptr);
      std::vector<char>().swap(reserve);
      try
        {
          std::cerr << "\nlumbricus: "
                    << out_of_memory_message(
                         bytes,
                         dealii::Utilities::MPI::this_mpi_process(comm),
                         comm)
                    << " " << memory_in_use()
                    << " The last checkpoint, where there is one, stays."
                    << std::endl;
        }
      catch (const std::exception &)
        {
          std::cerr << "\nlumbricus: Out of memory." << std::endl;
        }
      MPI_Abort(comm, ExitCode::solve_failed);
      std::_Exit(ExitCode::solve_failed);
    }



    void
    no_memory()
    {
      end_all_ranks(0., all_ranks);
    }
  } // namespace



  void
  end_all_ranks_when_memory_ends(const MPI_Comm comm)
  {
    reserve.resize(std::size_t(1) << 20);
    if (dealii::Utilities::MPI::n_mpi_processes(comm) == 1)
      return;
    all_ranks = comm;
    std::set_new_handler(no_memory);
  }



  void
  reserve_blas_memory()
  {
    // As much as it may want at most.
    constexpr std::size_t most  = std::size_t(128) << 20;
    void *const           probe = mmap(nullptr,
                             most,
                             PROT_READ | PROT_WRITE,
                             MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE,
                             -1,
                             0);
    if (probe == MAP_FAILED)
      throw std::bad_alloc();
    munmap(probe, most);

    // Large enough for deal.II to call LAPACK.
    dealii::FullMatrix<double> matrix(dealii::IdentityMatrix(32));
    matrix.gauss_jordan();
  }



  void
  abort_out_of_memory(const std::exception &exception, const MPI_Comm comm)
  {
    end_all_ranks(bytes_asked_for(exception), comm);
  }
} // namespace lumbricus
