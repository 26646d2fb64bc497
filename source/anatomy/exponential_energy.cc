// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/anatomy/exponential_energy.h>

#include <cmath>

namespace lumbricus
{
  using dealii::Tensor;

  double
  ExponentialEnergy::value(const double E) const
  {
    return k1 * (k2 == 0. ? 0.5 * E * E : std::expm1(k2 * E * E) / (2. * k2));
  }



  void
  ExponentialEnergy::add_stress(const Tensor<2, dim>                  &F,
                                const dealii::SymmetricTensor<2, dim> &M,
                                const double                           E,
                                const bool        with_tangent,
                                MaterialResponse &response) const
  {
    const double         growth = k1 * std::exp(k2 * E * E);
    const double         first  = growth * E;
    const double         second = growth * (1. + 2. * k2 * E * E);
    const Tensor<2, dim> FM     = F * Tensor<2, dim>(M);
    response.P += 2. * first * FM;
    if (!with_tangent)
      return;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int J = 0; J < dim; ++J)
        for (unsigned int k = 0; k < dim; ++k)
          for (unsigned int L = 0; L < dim; ++L)
            response.A[dim * i + J][dim * k + L] +=
              4. * second * FM[i][J] * FM[k][L] +
              (i == k ? 2. * first * M[J][L] : 0.);
  }
} // namespace lumbricus
