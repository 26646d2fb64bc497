// SPDX-License-Identifier: LGPL-2.1-or-later
// The inverse of small matrices whose unknowns have other units.
#include <lumbricus/linear/scaled_inverse.h>

#include <deal.II/lac/full_matrix.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace lumbricus;

namespace
{
  // How far A^(-1) is from being the inverse, with each unknown in its own unit.
  double
  error_of_inverse(const dealii::FullMatrix<double> &A,
                   const std::vector<double>        &unit)
  {
    dealii::FullMatrix<double> inverse = A, product(A.m(), A.m());
    scaled_inverse(inverse);
    A.mmult(product, inverse);
    double most = 0.;
    for (unsigned int i = 0; i < A.m(); ++i)
      for (unsigned int j = 0; j < A.m(); ++j)
        most = std::max(most,
                        std::abs(product(i, j) - (i == j ? 1. : 0.)) * unit[i] /
                          unit[j]);
    return most;
  }
} // namespace



TEST(ScaledInverse, DisplacementsOfAStiffTrialStateAndPressures)
{
  // A cell of crossed_fibres/shortens.prm amid Newton's method: deal.II's assertion
  // took it for singular, since the pivot of a pressure is 1e-16 of the diagonal.
  const double entries[] = {
    4.366443e+14, 2.719975e+13, 4.383068e+14, 0., 8.768675e-01, 2.658856e-03, -1.588242e-01,
    2.719975e+13, 4.100264e+12, 2.744296e+13, 0., -1.751146e+00, 3.409543e-02, -7.763712e-02,
    4.383068e+14, 2.744296e+13, 4.448965e+14, 0., -5.620960e-01, -1.054804e-01, -3.282151e-02,
    0., 0., 0., -7.194831e-03, -1.013156e-04, 0., 0.,
    8.768675e-01, -1.751146e+00, -5.620960e-01, -1.013156e-04, -7.194831e-03, 0., 0.,
    2.658856e-03, 3.409543e-02, -1.054804e-01, 0., 0., -7.337263e-03, 0.,
    -1.588242e-01, -7.763712e-02, -3.282151e-02, 0., 0., 0., -7.194831e-03};
  dealii::FullMatrix<double> A(7, 7, entries);
  std::vector<double>        unit;
  for (unsigned int i = 0; i < 7; ++i)
    unit.push_back(1. / std::sqrt(std::abs(A(i, i))));
  EXPECT_LT(error_of_inverse(A, unit), 1e-12);
}



TEST(ScaledInverse, IsThatWithoutUnits)
{
  // The same to the last bit in units of powers of two; zeros on the diagonal, and
  // no symmetry.
  const double               entries[] = {0., 2., -1., 3., 1., 0.5, 1., -2., 0.};
  dealii::FullMatrix<double> A(3, 3, entries);
  EXPECT_LT(error_of_inverse(A, {1., 1., 1.}), 1e-15);
  const double D[] = {std::ldexp(1., 40), std::ldexp(1., -31)};
  dealii::FullMatrix<double> B(2, 2), inverse(2, 2);
  for (unsigned int i = 0; i < 2; ++i)
    for (unsigned int j = 0; j < 2; ++j)
      {
        inverse(i, j) = i == j ? 3. : 1.;
        B(i, j)       = D[i] * inverse(i, j) * D[j];
      }
  inverse.gauss_jordan();
  scaled_inverse(B);
  for (unsigned int i = 0; i < 2; ++i)
    for (unsigned int j = 0; j < 2; ++j)
      EXPECT_EQ(B(i, j), inverse(i, j) / (D[i] * D[j]));
}
