// SPDX-License-Identifier: LGPL-2.1-or-later
#include "front_factors.h"

#include <deal.II/base/exceptions.h>
#include <deal.II/base/types.h>
#include <deal.II/lac/exceptions.h>
#include <deal.II/lac/lapack_templates.h>

#include <algorithm>
#include <cstddef>
#include <vector>

extern "C" void
strsv_(const char                    *uplo,
       const char                    *transposed,
       const char                    *diagonal,
       const dealii::types::blas_int *n,
       const float                   *a,
       const dealii::types::blas_int *lda,
       float                         *x,
       const dealii::types::blas_int *incx);

namespace lumbricus
{
  namespace
  {
    using BlasInt = dealii::types::blas_int;
  }



  void
  FrontFactors::reinit(const unsigned int size)
  {
    matrix.reinit(size, size);
    is_definite = false;
  }



  bool
  FrontFactors::factor(const bool symmetric, const RankGroup *group)
  {
    const unsigned int n = matrix.m();
    if (n == 0)
      return true;
    if (symmetric)
      {
        std::vector<float> diagonal(n);
        for (unsigned int r = 0; r < n; ++r)
          diagonal[r] = matrix(r, r);
        is_definite = factor_definite(group);
        if (is_definite)
          return true;
        // What is below the diagonal is as it was.
        for (unsigned int r = 0; r < n; ++r)
          {
            matrix(r, r) = diagonal[r];
            for (unsigned int s = 0; s < r; ++s)
              matrix(s, r) = matrix(r, s);
          }
      }
    try
      {
        matrix.compute_lu_factorization();
      }
    catch (const dealii::LACExceptions::ExcSingular &)
      {
        return false;
      }
    return true;
  }



  bool
  FrontFactors::factor_definite(const RankGroup *group)
  {
    const unsigned int n       = matrix.m();
    const unsigned int n_ranks = group == nullptr ? 1 : group->size();
    const unsigned int own     = group == nullptr ? 0 : group->own();
    // The rows of a block are those of the rank whose turn it is.
    const auto turn_of = [&](const unsigned int first) {
      return (first / block_size) % n_ranks;
    };
    for (unsigned int first = 0; first < n; first += block_size)
      {
        const unsigned int end = std::min(first + block_size, n);
        bool               is_there =
          turn_of(first) == own && factor_block(first, end);
        if (n_ranks > 1)
          is_there = tell_block(first, end, *group, turn_of(first), is_there);
        if (!is_there)
          return false;
        for (unsigned int rows = end; rows < n; rows += block_size)
          if (turn_of(rows) == own)
            subtract_block(first, end, rows, std::min(rows + block_size, n));
      }
    return true;
  }



  bool
  FrontFactors::factor_block(const unsigned int first, const unsigned int end)
  {
    const BlasInt n = matrix.m(), n_rows = end - first, n_behind = n - end;
    BlasInt       info = 0;
    dealii::potrf("U", &n_rows, &matrix(first, first), &n, &info);
    if (info != 0)
      return false;
    if (n_behind > 0)
      dealii::trtrs("U",
                    "T",
                    "N",
                    &n_rows,
                    &n_behind,
                    &matrix(first, first),
                    &n,
                    &matrix(first, end),
                    &n,
                    &info);
    return info == 0;
  }



  void
  FrontFactors::subtract_block(const unsigned int first,
                               const unsigned int end,
                               const unsigned int begin_rows,
                               const unsigned int end_rows)
  {
    // Of the diagonal block all entries change, also those below the diagonal,
    // which are to stay.
    const BlasInt      n = matrix.m(), n_rows = end_rows - begin_rows;
    const BlasInt      n_columns = n - begin_rows, n_terms = end - first;
    std::vector<float> below;
    for (unsigned int s = begin_rows; s < end_rows; ++s)
      for (unsigned int r = s + 1; r < end_rows; ++r)
        below.push_back(matrix(r, s));
    const float minus_one = -1., one = 1.;
    dealii::gemm("T",
                 "N",
                 &n_rows,
                 &n_columns,
                 &n_terms,
                 &minus_one,
                 &matrix(first, begin_rows),
                 &n,
                 &matrix(first, begin_rows),
                 &n,
                 &one,
                 &matrix(begin_rows, begin_rows),
                 &n);
    auto value = below.begin();
    for (unsigned int s = begin_rows; s < end_rows; ++s)
      for (unsigned int r = s + 1; r < end_rows; ++r)
        matrix(r, s) = *value++;
  }



  bool
  FrontFactors::tell_block(const unsigned int first,
                           const unsigned int end,
                           const RankGroup   &group,
                           const unsigned int i,
                           const bool         is_there)
  {
    const unsigned int n = matrix.m(), n_rows = end - first;
    std::vector<float> told(std::size_t(n_rows) * (n - first) + 1, 0.);
    if (group.own() == i)
      {
        for (unsigned int s = first; s < n; ++s)
          std::copy_n(&matrix(first, s),
                      n_rows,
                      &told[std::size_t(s - first) * n_rows]);
        told.back() = is_there ? 1. : 0.;
      }
    group.tell(told, i);
    if (group.own() != i)
      for (unsigned int s = first; s < n; ++s)
        std::copy_n(&told[std::size_t(s - first) * n_rows],
                    std::min(s - first + 1, n_rows),
                    &matrix(first, s));
    return told.back() == 1.;
  }



  void
  FrontFactors::solve(dealii::Vector<float> &x) const
  {
    if (!is_definite)
      {
        matrix.solve(x, true);
        return;
      }
    const BlasInt n = matrix.m(), step = 1;
    for (const char *const transposed : {"T", "N"})
      strsv_("U", transposed, "N", &n, &matrix(0, 0), &n, x.data(), &step);
  }



  void
  FrontFactors::solve_transposed(dealii::LAPACKFullMatrix<float> &columns) const
  {
    if (!is_definite)
      {
        matrix.solve(columns, false);
        return;
      }
    const BlasInt n = matrix.m(), n_columns = columns.n();
    BlasInt       info = 0;
    for (const char *const transposed : {"T", "N"})
      dealii::trtrs("U",
                    transposed,
                    "N",
                    &n,
                    &n_columns,
                    &matrix(0, 0),
                    &n,
                    &columns(0, 0),
                    &n,
                    &info);
    Assert(info == 0, dealii::ExcInternalError());
  }
} // namespace lumbricus
