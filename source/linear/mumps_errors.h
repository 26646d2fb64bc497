// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_mumps_errors_h
#define lumbricus_linear_mumps_errors_h

#include <deal.II/base/mpi.h>

#include <cstddef>
#include <string>

namespace lumbricus
{
  /** What a call of MUMPS has come to; codes below zero are errors. */
  struct MumpsResult
  {
    int code;     ///< INFOG(1), the same on all ranks of this MUMPS
    int detail;   ///< INFOG(2), what it means depends on the code
    int own_code; ///< INFO(1), of this rank
  };

  /** Whether the analysis foresaw too little room, as delayed pivots need more. */
  bool
  is_out_of_estimate(const int code);

  /** Whether memory ends. */
  bool
  is_out_of_memory(const int code);

  /** Throw on all ranks of @p told where MUMPS has failed at @p what on some:
   * ExcNotConverged for a singular matrix, or ExcSolveFailed. Its numbers have
   * @p number_size bytes; @p all_know says whether it is one MUMPS on all these
   * ranks. Collective. */
  void
  check_mumps(const MumpsResult &result,
              const std::string &what,
              const std::size_t  number_size,
              const bool         all_know,
              const MPI_Comm     told);
} // namespace lumbricus

#endif
