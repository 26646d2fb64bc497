// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mumps_errors.h"

#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/out_of_memory.h>

#include <dmumps_c.h>

#include <algorithm>
#include <cstdlib>

namespace lumbricus
{
  namespace
  {
    const std::string advice =
      "Its manual says what that is. Try another 'Linear solver/Method'.";

    // Delayed pivots may need more room than the analysis foresaw.
    constexpr int out_of_estimate[] = {-8, -9, -20};

    // Real and integer workspace, and what it allocates besides; more room than
    // was foreseen, where that is not to be had either; its own limit.
    constexpr int out_of_memory[] = {
      -5, -7, -8, -9, -11, -13, -14, -15, -19, -20};

    template <std::size_t n>
    bool
    is_one_of(const int code, const int (&codes)[n])
    {
      return std::find(codes, codes + n, code) != codes + n;
    }
  } // namespace



  bool
  is_out_of_estimate(const int code)
  {
    return is_one_of(code, out_of_estimate);
  }



  bool
  is_out_of_memory(const int code)
  {
    return is_one_of(code, out_of_memory);
  }



  void
  check_mumps(const MumpsResult &result,
              const std::string &what,
              const std::size_t  number_size,
              const bool         all_know,
              const MPI_Comm     told)
  {
    // Other ranks that are told may have a MUMPS of their own, which is content.
    const int code = all_know ?
                       result.code :
                       dealii::Utilities::MPI::min(result.code, told);
    if (code >= 0)
      return;
    AssertThrow(code != -10,
                ExcNotConverged("The tangent matrix is singular"));
    const bool is_here = result.code == code;
    const int  detail  = dealii::Utilities::MPI::max(
      is_here ? std::abs(result.detail) : 0, told);
    if (is_out_of_memory(code))
      {
        // Entries, in millions where there are many; only the rank concerned
        // has the code itself.
        const bool in_millions = dealii::Utilities::MPI::logical_or(
          is_here && result.detail < 0, told);
        const double       entries_lacking = in_millions ? 1e6 * detail : detail;
        const bool         integers        = code == -7 || code == -8;
        const unsigned int n_ranks =
          dealii::Utilities::MPI::n_mpi_processes(told);
        const unsigned int rank = dealii::Utilities::MPI::min(
          result.own_code == code ?
            dealii::Utilities::MPI::this_mpi_process(told) :
            n_ranks,
          told);
        AssertThrow(false,
                    ExcSolveFailed(
                      out_of_memory_message(
                        entries_lacking *
                          (integers ? sizeof(MUMPS_INT) : number_size),
                        rank < n_ranks ? rank : 0,
                        told) +
                      " (In the " + what + " by MUMPS, code " +
                      std::to_string(code) + ".)"));
      }
    AssertThrow(false,
                ExcSolveFailed("The " + what + " by MUMPS failed with code " +
                               std::to_string(code) + ", " +
                               std::to_string(detail) + ". " + advice));
  }
} // namespace lumbricus
