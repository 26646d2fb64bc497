// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/materials/volume_split.h>

#include <deal.II/base/patterns.h>

#include <cmath>

namespace lumbricus
{
  using dealii::SymmetricTensor;
  using dealii::Tensor;

  namespace
  {
    IsochoricStrain
    isochoric_strain(const Tensor<2, dim> &F,
                     const double          J,
                     const ReferencePoint &reference)
    {
      const Tensor<2, dim> Fbar_e =
        std::pow(J, -1. / dim) * F * reference.G_inverse;
      IsochoricStrain strain;
      strain.bbar = dealii::symmetrize(Fbar_e * dealii::transpose(Fbar_e));
      strain.fibres.reserve(reference.fibres.size());
      for (const Tensor<1, dim> &Gf : reference.fibres)
        strain.fibres.push_back(Fbar_e * Gf / Gf.norm());
      return strain;
    }



    // The spatial tangent of tau at fixed p, without the geometric part
    // delta_ik tau_jl: the isochoric part is
    //   P:cbar:P + 2/3 tr(taubar) P - 2/3 (I x tau_iso + tau_iso x I),
    // with P the deviatoric projector, and that of the pressure p J (I x I - 2
    // S).
    SymmetricTensor<4, dim>
    spatial_tangent(const SymmetricTensor<2, dim> &taubar,
                    const SymmetricTensor<2, dim> &tau_iso,
                    const SymmetricTensor<4, dim> &cbar,
                    const double                   J_v,
                    const double                   p_J)
    {
      const SymmetricTensor<2, dim> I =
        dealii::unit_symmetric_tensor<dim, double>();
      static const SymmetricTensor<4, dim> S =
        dealii::identity_tensor<dim, double>();
      static const SymmetricTensor<4, dim> II = dealii::outer_product(I, I);

      // P:cbar:P = cbar - 1/3 (I x m + m x I) + 1/9 tr(m) I x I, m = cbar:I.
      const SymmetricTensor<2, dim> m = cbar * I;
      const SymmetricTensor<2, dim> n = m / 3. + 2. / 3. * tau_iso;

      SymmetricTensor<4, dim> c = cbar;
      c += 2. / 3. * trace(taubar) * S;
      c += (trace(m) / 9. - 2. / 9. * trace(taubar)) * II;
      // I x n + n x I: most of it is zeros.
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int k = 0; k < dim; ++k)
          for (unsigned int l = k; l < dim; ++l)
            {
              c[i][i][k][l] -= n[k][l];
              c[k][l][i][i] -= n[k][l];
            }
      return J_v * c + p_J * (II - 2. * S);
    }
  } // namespace



  void
  VolumeSplit::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("nu",
                      nu,
                      "[-] Poisson's ratio; 0.5 is exactly incompressible.",
                      dealii::Patterns::Double(0., 0.5));
  }



  double
  VolumeSplit::compressibility() const
  {
    return 3. * (1. - 2. * nu) / (2. * shear_modulus() * (1. + nu));
  }



  double
  VolumeSplit::energy(const Tensor<2, dim> &F,
                       const double          p,
                       const ReferencePoint &reference) const
  {
    const double J      = determinant(F);
    const auto   strain = isochoric_strain(F, J, reference);
    return reference.J_v *
           (energy_at(strain) + p * (J / reference.J_v - 1.) -
            0.5 * p * p * compressibility());
  }



  void
  VolumeSplit::evaluate(const Tensor<2, dim> &F,
                         const double          p,
                         const ReferencePoint &reference,
                         const bool            with_tangent,
                         MaterialResponse     &response) const
  {
    const double         J       = determinant(F);
    const Tensor<2, dim> F_inv   = invert(F);
    const Tensor<2, dim> F_inv_T = transpose(F_inv);

    const auto strain  = isochoric_strain(F, J, reference);
    const auto taubar  = stress_at(strain);
    const auto tau_iso = deviator(taubar);
    const auto tau =
      reference.J_v * tau_iso + p * J * dealii::unit_symmetric_tensor<dim>();

    response.P     = Tensor<2, dim>(tau) * F_inv_T;
    response.Q     = J * F_inv_T;
    response.c     = J - reference.J_v * (1. + p * compressibility());
    response.dc_dp = -reference.J_v * compressibility();

    if (!with_tangent)
      return;

    const auto c_spatial =
      spatial_tangent(taubar, tau_iso, tangent_at(strain), reference.J_v, p * J);

    // A_iJkL = F^(-1)_Jj (c_ijkl + delta_ik tau_jl) F^(-1)_Ll, one index
    // at a time; B holds F^(-1)_Jj (...)_ijkl.
    double B[dim * dim][dim * dim];
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int k = 0; k < dim; ++k)
        for (unsigned int l = 0; l < dim; ++l)
          {
            double a[dim];
            for (unsigned int j = 0; j < dim; ++j)
              a[j] = c_spatial[i][j][k][l] + (i == k ? tau[j][l] : 0.);
            for (unsigned int J = 0; J < dim; ++J)
              B[dim * i + J][dim * k + l] =
                F_inv[J][0] * a[0] + F_inv[J][1] * a[1] + F_inv[J][2] * a[2];
          }
    for (unsigned int iJ = 0; iJ < dim * dim; ++iJ)
      for (unsigned int k = 0; k < dim; ++k)
        for (unsigned int L = 0; L < dim; ++L)
          response.A[iJ][dim * k + L] = B[iJ][dim * k] * F_inv[L][0] +
                                        B[iJ][dim * k + 1] * F_inv[L][1] +
                                        B[iJ][dim * k + 2] * F_inv[L][2];
  }
} // namespace lumbricus
