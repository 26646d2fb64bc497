// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/anatomy/viscous_branch.h>
#include <lumbricus/parameters/patterns.h>

#include <cmath>

namespace lumbricus
{
  using dealii::SymmetricTensor;
  using dealii::Tensor;

  namespace
  {
    SymmetricTensor<2, dim>
    shape(const Tensor<2, dim> &F)
    {
      return std::pow(determinant(F), -2. / dim) *
             dealii::symmetrize(transpose(F) * F);
    }



    // 1/x int exp(-y) dy from 0 to x > 0.
    double
    mean_left(const double x)
    {
      return -std::expm1(-x) / x;
    }



    // Integrals over a step, y from 0 to x > 0, of products of exp(-y) and of
    // (1 - exp(-y))/x: how s goes on from s_n, and what motion adds to it.
    struct Integrals
    {
      explicit Integrals(const double x)
        : past(0.5 * -std::expm1(-2. * x))
        , both(x * mean_left(x) * mean_left(x))
      {
        const double lost = -std::expm1(-x);
        motion            = x < 0.01 ?
                              x / 3. - x * x / 4. + 7. / 60. * x * x * x :
                              (x - lost - 0.5 * lost * lost) / (x * x);
      }

      double past;
      double both; ///< twice the mixed one
      double motion;
    };
  } // namespace



  SymmetricTensor<2, dim>
  inverse_shape(const Tensor<2, dim> &F)
  {
    const Tensor<2, dim> F_inverse = invert(F);
    return std::pow(determinant(F), 2. / dim) *
           dealii::symmetrize(F_inverse * transpose(F_inverse));
  }



  SymmetricTensor<2, dim>
  ViscousPoint::at_end(const Tensor<2, dim> &F) const
  {
    return x > 0. ? kept + (1. - mean_left(x)) * inverse_shape(F) : kept;
  }



  ViscousBranch::ViscousBranch(const std::string & /*name*/)
  {}



  void
  ViscousBranch::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Shear modulus",
                      mu,
                      "[N/mm^2] That by which it stiffens the law against a "
                      "motion that is quick for its relaxation time.",
                      PositiveNumber());
    prm.add_parameter("Relaxation time",
                      tau,
                      "[time] In which its stress falls to 1/e of what it was, "
                      "where the shape is held. Load steps should be shorter.",
                      PositiveNumber());
  }



  ViscousPoint
  ViscousBranch::in_step(const SymmetricTensor<2, dim> &b,
                         const SymmetricTensor<2, dim> &inverse,
                         const double                   since) const
  {
    ViscousPoint point;
    point.before = b;
    point.kept   = b;
    point.x      = since / tau;
    if (point.x > 0.)
      {
        const double e = std::exp(-point.x);
        point.kept     = e * b + (mean_left(point.x) - e) * inverse;
      }
    return point;
  }



  double
  ViscousBranch::energy(const Tensor<2, dim>          &F,
                        const SymmetricTensor<2, dim> &b) const
  {
    return 0.5 * mu * (shape(F) * b - dim - std::log(determinant(b)));
  }



  double
  ViscousBranch::dissipated(const Tensor<2, dim> &F_n,
                            const Tensor<2, dim> &F,
                            const ViscousPoint   &point) const
  {
    if (!(point.x > 0.))
      return 0.;
    const Integrals               integrals(point.x);
    const SymmetricTensor<2, dim> inverse = inverse_shape(F_n);
    const Tensor<2, dim>          past    = inverse - point.before;
    const Tensor<2, dim>          motion  = inverse_shape(F) - inverse;
    double                        sum     = 0.;
    const auto add_end = [&](const Tensor<2, dim>          &F,
                             const SymmetricTensor<2, dim> &b) {
      const Tensor<2, dim> b_inverse = invert(b), Cbar = shape(F);
      const auto product = [&](const Tensor<2, dim> &one,
                               const Tensor<2, dim> &other) {
        return trace(b_inverse * one * Cbar * other);
      };
      sum += integrals.past * product(past, past) +
             0.5 * integrals.both *
               (product(past, motion) + product(motion, past)) +
             integrals.motion * product(motion, motion);
    };
    add_end(F_n, point.before);
    add_end(F, point.at_end(F));
    return 0.25 * mu * sum;
  }



  void
  ViscousBranch::add_stress(const Tensor<2, dim> &F,
                            const ViscousPoint   &point,
                            const bool            with_tangent,
                            MaterialResponse     &response) const
  {
    const double c = mu * std::pow(determinant(F), -2. / dim);
    const SymmetricTensor<2, dim> &h  = point.kept;
    const Tensor<2, dim>           Fh = F * h;
    const Tensor<2, dim>           G  = transpose(invert(F));
    const double                   t  = scalar_product(F, Fh) / dim; // tr(C h)/3
    response.P += c * (Fh - t * G);
    if (!with_tangent)
      return;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int J = 0; J < dim; ++J)
        for (unsigned int k = 0; k < dim; ++k)
          for (unsigned int L = 0; L < dim; ++L)
            response.A[dim * i + J][dim * k + L] +=
              c * ((i == k ? h[J][L] : 0.) + t * G[i][L] * G[k][J] -
                   2. / dim *
                     (Fh[i][J] * G[k][L] + G[i][J] * Fh[k][L] -
                      t * G[i][J] * G[k][L]));
  }
} // namespace lumbricus
