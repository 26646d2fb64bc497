// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_global_rows_h
#define lumbricus_linear_global_rows_h

#include <lumbricus/discretization/border.h>
#include <lumbricus/linear/free_numbering.h>
#include <lumbricus/linear/mumps.h>

#include <deal.II/base/mpi.h>

#include <optional>
#include <vector>

namespace lumbricus
{
  /** A Border as entries of the matrix that is factored. */
  struct GlobalRows
  {
    /** Rows and columns of the global unknowns. */
    MoreEntries entries;
    /** Each row of the border is multiplied by this, and so is its right-hand
     * side: where the matrix is symmetric, such that C = B^T. */
    std::vector<double> scale;
  };



  /**
   * What @p border adds to a matrix in the unknowns in @p numbering; nothing where
   * it hangs on others, or where the matrix is to be @p symmetric and cannot be
   * made so row by row. Collective.
   */
  std::optional<GlobalRows>
  global_rows(const Border        &border,
              const FreeNumbering &numbering,
              const bool           symmetric,
              const MPI_Comm       comm);
} // namespace lumbricus

#endif
