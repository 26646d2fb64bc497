// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/linear/scaled_inverse.h>

#include <cmath>
#include <vector>

namespace lumbricus
{
  void
  scaled_inverse(dealii::FullMatrix<double> &A)
  {
    std::vector<double> D;
    for (unsigned int i = 0; i < A.m(); ++i)
      {
        const double size = std::abs(A(i, i));
        D.push_back(size > 0. && std::isfinite(size) ?
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
