// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_benchmarks_kernels_machine_h
#define lumbricus_benchmarks_kernels_machine_h

#include <lumbricus/discretization/dgemm.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <vector>

// What one core of this machine can do at most, as a measure of what a kernel
// makes of it.
namespace machine
{
  /** Seconds that @p action takes, the least of @p n_repetitions. */
  template <typename Action>
  double
  least_seconds(const unsigned int n_repetitions, const Action &action)
  {
    using Clock  = std::chrono::steady_clock;
    double least = std::numeric_limits<double>::max();
    for (unsigned int r = 0; r < n_repetitions; ++r)
      {
        const auto begin = Clock::now();
        action();
        const std::chrono::duration<double> seconds = Clock::now() - begin;
        least = std::min(least, seconds.count());
      }
    return least;
  }



  /** Of the product of two square matrices, by the BLAS of the program. */
  inline double
  gigaflops_of_dgemm()
  {
    const int                 n   = 1000;
    const double              one = 1., zero = 0.;
    const std::vector<double> A(n * n, 1.), B(n * n, 2.);
    std::vector<double>       C(n * n);
    const double              seconds = least_seconds(50, [&]() {
      dgemm_("N",
             "N",
             &n,
             &n,
             &n,
             &one,
             A.data(),
             &n,
             B.data(),
             &n,
             &zero,
             C.data(),
             &n);
    });
    return 2e-9 * n * n * n / seconds;
  }



  /** Of a = b + s c on vectors that no cache holds: two are read and one is
   * written, as STREAM counts it. */
  inline double
  gigabytes_per_second_of_triad()
  {
    constexpr std::size_t n = 32 << 20; // 256 MB each
    std::vector<double>   a(n), b(n, 1.), c(n, 2.);
    const double          s       = 3.;
    const double          seconds = least_seconds(20, [&]() {
      double *const       to     = a.data();
      const double *const first  = b.data();
      const double *const second = c.data();
#pragma GCC ivdep
      for (std::size_t k = 0; k < n; ++k)
        to[k] = first[k] + s * second[k];
    });
    return 3e-9 * n * sizeof(double) / seconds;
  }
} // namespace machine

#endif
