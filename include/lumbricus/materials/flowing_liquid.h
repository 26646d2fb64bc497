// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_materials_flowing_liquid_h
#define lumbricus_materials_flowing_liquid_h

#include <lumbricus/materials/material_law.h>

namespace lumbricus
{
  /**
   * The response of a liquid of the law @p law that flows: the shape that it has
   * at @p F is free of shear, its stress-free volume is @p J_v,
   *
   *   P = p J F^(-T),   c as the law says.
   *
   * The nodes inside a liquid without shear are held by nothing, so A is the
   * derivative of P and a ten-thousandth of the shear stiffness of the law. What
   * preconditioners are to have more is MaterialResponse::mu_missing.
   */
  void
  flowing_response(const MaterialLaw            &law,
                   const dealii::Tensor<2, dim> &F,
                   const double                  p,
                   const double                  J_v,
                   const bool                    with_tangent,
                   MaterialResponse             &response);

  /**
   * Add to @p A, at [3 i + J][3 k + L], the shear stiffness of a solid with the
   * modulus mu that is free of stress in the shape F,
   *
   *   2 mu J F^(-1)_Jj D_ijkl F^(-1)_Ll,
   *
   * times a weight w, where D makes a tensor symmetric and deviatoric: @p Q is
   * w J F^(-T), and @p factor is mu / (w J).
   */
  void
  add_shear_stiffness(const double                  factor,
                      const dealii::Tensor<2, dim> &Q,
                      double (&A)[dim * dim][dim * dim]);
} // namespace lumbricus

#endif
