// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/materials/material_law.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/symmetric_tensor.h>

namespace lumbricus
{
  using dealii::SymmetricTensor;
  using dealii::Tensor;

  /**
   * Hooke's law of small strain (paper, equations 1 and 2), mixed:
   *
   *   psi = mu e : e + p (tr eps - (J_v - 1)) - p^2 / (2 kappa),
   *   eps = sym(F - I),   e = dev(eps - sym(G - I)),   P = 2 mu e + p I.
   *
   * Volume is kept, at nu = 0.5 too, to first order only, and rotations are
   * strains: it is there for comparison. A muscle or a liquid of this law has
   * its reference map to first order.
   */
  class Hooke : public MaterialLaw
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("E", E, "[N/mm^2] Young's modulus.", PositiveNumber());
      prm.add_parameter("nu",
                        nu,
                        "[-] Poisson's ratio; 0.5 is incompressible to first "
                        "order.",
                        dealii::Patterns::Double(0., 0.5));
    }

    double
    shear_modulus() const override
    {
      return E / (2. * (1. + nu));
    }

    void
    scale_stiffness(const double factor) override
    {
      E *= factor;
    }

    double
    energy(const Tensor<2, dim> &F,
           const double          p,
           const ReferencePoint &reference) const override
    {
      const auto e = elastic_deviator(F, reference);
      return shear_modulus() * (e * e) +
             p * (trace(F) - dim - (reference.J_v - 1.)) -
             0.5 * p * p * compressibility();
    }

    void
    evaluate(const Tensor<2, dim> &F,
             const double          p,
             const ReferencePoint &reference,
             const bool            with_tangent,
             MaterialResponse     &response) const override
    {
      const double mu = shear_modulus();
      const auto   I  = dealii::unit_symmetric_tensor<dim, double>();
      response.P      = 2. * mu * elastic_deviator(F, reference) + p * I;
      response.Q      = I;
      response.c =
        trace(F) - dim - (reference.J_v - 1.) - p * compressibility();
      response.dc_dp = -compressibility();

      if (!with_tangent)
        return;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int J = 0; J < dim; ++J)
          for (unsigned int k = 0; k < dim; ++k)
            for (unsigned int L = 0; L < dim; ++L)
              response.A[dim * i + J][dim * k + L] =
                mu * ((i == k) * (J == L) + (i == L) * (J == k)) -
                2. / dim * mu * (i == J) * (k == L);
    }

  private:
    /** 1/kappa. */
    double
    compressibility() const
    {
      return 3. * (1. - 2. * nu) / E;
    }

    static SymmetricTensor<2, dim>
    elastic_deviator(const Tensor<2, dim> &F, const ReferencePoint &reference)
    {
      return dealii::deviator(
        dealii::symmetrize(F - dealii::invert(reference.G_inverse)));
    }

    double E  = 0.69;
    double nu = 0.5;
  };

  static const Register<MaterialLaw, Hooke>
    hooke("Hooke",
          "sigma = 2 mu dev(eps) + p I of small strain; it changes the volume "
          "and takes rotations for strains: for comparison only.");
} // namespace lumbricus
