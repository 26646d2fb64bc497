// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_mpi_session_h
#define lumbricus_core_mpi_session_h

#include <deal.II/base/mpi.h>

#include <array>

namespace lumbricus
{
  /**
   * MPI, on one thread per rank, and the libraries that deal.II starts with it,
   * for as long as this object lives.
   *
   * They are told the name of the program but none of its arguments: PETSc,
   * SLEPc, Kokkos and Zoltan, as far as deal.II was built with them, read
   * options of their own there, and complain about those that are not theirs.
   */
  class MpiSession
  {
  public:
    /** Start MPI. @p program_name, argv[0] of main(), may be null.
     * Collective. */
    explicit MpiSession(char *program_name)
      : arguments{{program_name, nullptr}}
      , n_arguments(program_name == nullptr ? 0 : 1)
      , argument_list(arguments.data())
      , libraries(n_arguments, argument_list, 1)
    {}

    MpiSession(const MpiSession &) = delete;
    MpiSession &
    operator=(const MpiSession &) = delete;

  private:
    // PETSc keeps the address of the arguments until it ends.
    std::array<char *, 2>                    arguments;
    int                                      n_arguments;
    char                                   **argument_list;
    dealii::Utilities::MPI::MPI_InitFinalize libraries;
  };
} // namespace lumbricus

#endif
