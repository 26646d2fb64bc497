// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/linear/scaled_inverse.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace lumbricus
{
  void
  scaled_inverse(dealii::FullMatrix<double> &A)
  {
    // Below that deal.II takes pivots for zero.
    constexpr double smallest = 1e-15;
    double           least    = std::numeric_limits<double>::max(), mean = 0.;
    for (unsigned int i = 0; i < A.m(); ++i)
      {
        least = std::min(least, std::abs(A(i, i)));
        mean += std::abs(A(i, i)) / A.m();
      }
    std::vector<double> D;
    for (unsigned int i = 0; i < A.m(); ++i)
      {
        const double size = std::abs(A(i, i));
        D.push_back(least < smallest * mean && size > 0. && std::isfinite(size) ?
                      std::exp2(-std::floor(0.5 * std::ilogb(size))) :
                      1.);
      }
    const auto scale = [&]() {
      for (unsigned int i = 0; i < A.m(); ++i)
        for (unsigned int j = 0; j < A.n(); ++j)
          A(i, j) *= D[i] * D[j];
    };
    scale();
    A.gauss_jordan();
    scale();
  }
} // namespace lumbricus
