// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/materials/flowing_liquid.h>

#include <cmath>

namespace lumbricus
{
  using dealii::Tensor;

  namespace
  {
    // Of the shear modulus while the liquid flows (doc/performance.md). Newton's
    // method leaves a ten-thousandth of what it would with the whole modulus, and with
    // none nothing holds the nodes inside; factors like more of it.
    constexpr double part_in_tangent        = 1e-4;
    constexpr double part_in_preconditioner = 2.;
  } // namespace



  void
  add_shear_stiffness(const double          factor,
                      const Tensor<2, dim> &Q,
                      double (&A)[dim * dim][dim * dim])
  {
    const Tensor<2, dim> QQ = transpose(Q) * Q;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int J = 0; J < dim; ++J)
        for (unsigned int k = 0; k < dim; ++k)
          for (unsigned int L = 0; L < dim; ++L)
            A[dim * i + J][dim * k + L] +=
              factor * ((i == k ? QQ[J][L] : 0.) + Q[k][J] * Q[i][L] -
                        2. / 3. * Q[i][J] * Q[k][L]);
  }



  void
  flowing_response(const MaterialLaw    &law,
                   const Tensor<2, dim> &F,
                   const double          p,
                   const double          J_v,
                   const bool            with_tangent,
                   MaterialResponse     &response)
  {
    const double   J = determinant(F);
    ReferencePoint reference;
    reference.G_inverse = std::cbrt(J) * invert(F);
    reference.J_v       = J_v;
    law.evaluate(F, p, reference, false, response);
    if (!with_tangent)
      return;

    // d(p J F^(-T))_im / dF_kL = p (Q_im Q_kL - Q_iL Q_km) / J
    const Tensor<2, dim> &Q = response.Q;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int m = 0; m < dim; ++m)
        for (unsigned int k = 0; k < dim; ++k)
          for (unsigned int L = 0; L < dim; ++L)
            response.A[dim * i + m][dim * k + L] =
              p / J * (Q[i][m] * Q[k][L] - Q[i][L] * Q[k][m]);
    const double mu = law.shear_modulus();
    add_shear_stiffness(part_in_tangent * mu / J, Q, response.A);
    response.mu_missing = (part_in_preconditioner - part_in_tangent) * mu;
  }
} // namespace lumbricus
