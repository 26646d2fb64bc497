// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_front_factors_h
#define lumbricus_linear_front_factors_h

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include "rank_group.h"

namespace lumbricus
{
  /**
   * The factors of the dense square matrix F of a SharedFront, in single precision:
   * of a symmetric and positive definite one
   *
   *   F = U^T U,
   *
   * else L U with exchanges of rows. For U^T U ranks that share a front compute
   * block rows by turns and tell them to the others; the L U of it each computes
   * by itself. Then each has all.
   */
  class FrontFactors
  {
  public:
    /** Block rows have so many rows. */
    static constexpr unsigned int block_size = 128;

    /** Make F a matrix of zeros of this @p size; zero ends it. */
    void
    reinit(const unsigned int size);

    /** F_rs, until it is factored; entries of a row follow each other. */
    float &
    entry(const unsigned int r, const unsigned int s)
    {
      return matrix(s, r);
    }

    /** Factor F, which all ranks of the @p group have, if there is one, and which
     * may be indefinite where it is @p symmetric. Collective in the group.
     * @return whether it is regular. */
    bool
    factor(const bool symmetric, const RankGroup *group);

    /** Replace @p x by F^(-1) x. */
    void
    solve(dealii::Vector<float> &x) const;

    /** Replace all columns by F^(-T) times them. */
    void
    solve_transposed(dealii::LAPACKFullMatrix<float> &columns) const;

  private:
    /** Make the upper triangle U.
     * @return whether the matrix is positive definite. */
    bool
    factor_definite(const RankGroup *group);

    /** The rows first, ..., end - 1 of U, from what rows above have left.
     * @return whether that is positive definite. */
    bool
    factor_block(const unsigned int first, const unsigned int end);

    /** Take what the rows first, ..., end - 1 of U contribute to U^T U from the
     * rows begin_rows, ..., end_rows - 1. */
    void
    subtract_block(const unsigned int first,
                   const unsigned int end,
                   const unsigned int begin_rows,
                   const unsigned int end_rows);

    /** Tell all of a @p group the rows first, ..., end - 1 of U, which number
     * @p i of them has, and whether they are there.
     * @return that. */
    bool
    tell_block(const unsigned int first,
               const unsigned int end,
               const RankGroup   &group,
               const unsigned int i,
               const bool         is_there);

    dealii::LAPACKFullMatrix<float> matrix; // F^T, by columns
    bool                            is_definite = false;
  };
} // namespace lumbricus

#endif
