// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/materials/volume_split.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/registry.h>

#include <cmath>

namespace lumbricus
{
  using dealii::SymmetricTensor;
  using dealii::Tensor;

  /**
   * Guccione's law (J. Biomech. Eng. 113, 42, 1991), transversely isotropic, on
   * the isochoric part E = (Cbar - I)/2 of the strain, f along the fibres:
   *
   *   W = C/2 (exp(Q) - 1),
   *   Q = b_f E_ff^2 + b_t (E_ss^2 + E_nn^2 + 2 E_sn^2)
   *       + 2 b_fs (E_fs^2 + E_fn^2)
   *     = b_t E : E + (b_f - 2 b_fs + b_t) E_ff^2 + 2 (b_fs - b_t) |E f|^2.
   *
   * With a = Fbar_e f all of it is in bbar and a: E : E = tr (bbar - I)^2 / 4,
   * E_ff = (a.a - 1)/2, |E f|^2 = (a.bbar a - 2 a.a + 1)/4. For mu stands the
   * mean of the three shear moduli at rest.
   */
  class Guccione : public VolumeSplit
  {
  public:
    Guccione()
      : fibres("Fibres",
               "longitudinal",
               "The direction of the fibres at rest.")
    {}

    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("C",
                        C,
                        "[N/mm^2] Stiffness; 2 kPa are 0.002 N/mm^2.",
                        PositiveNumber());
      prm.add_parameter("b_f",
                        b_f,
                        "[-] How fast it stiffens along the fibres.",
                        PositiveNumber());
      prm.add_parameter("b_t",
                        b_t,
                        "[-] How fast it stiffens across the fibres.",
                        PositiveNumber());
      prm.add_parameter("b_fs",
                        b_fs,
                        "[-] How fast it stiffens in shear along the fibres.",
                        PositiveNumber());
      fibres.declare_parameters(prm);
      VolumeSplit::declare_parameters(prm);
    }

    bool
    extend_parameters(dealii::ParameterHandler &prm,
                      const Extent              extent) override
    {
      return fibres.extend_parameters(prm, extent);
    }

    void
    check_parameters() const override
    {
      fibres.check_parameters();
    }

    void
    initialize(const std::string &section, const Geometry &geometry) override
    {
      fibres.get()->initialize(fibres.section_in(section), geometry);
    }

    std::vector<const FibreField *>
    fibre_fields() const override
    {
      return {fibres.get()};
    }

    double
    shear_modulus() const override
    {
      return C * (b_t + 2. * b_fs) / 6.;
    }

    void
    scale_stiffness(const double factor) override
    {
      C *= factor;
    }

  protected:
    double
    energy_at(const IsochoricStrain &strain) const override
    {
      return 0.5 * C * std::expm1(exponent(strain));
    }

    SymmetricTensor<2, dim>
    stress_at(const IsochoricStrain &strain) const override
    {
      return 0.5 * C * std::exp(exponent(strain)) * slope(strain);
    }

    SymmetricTensor<4, dim>
    tangent_at(const IsochoricStrain &strain) const override
    {
      const SymmetricTensor<2, dim> &b = strain.bbar;
      const Tensor<1, dim>          &a = strain.fibres[0];
      const SymmetricTensor<2, dim>  q = slope(strain);
      SymmetricTensor<4, dim>        c;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = i; j < dim; ++j)
          for (unsigned int k = 0; k < dim; ++k)
            for (unsigned int l = k; l < dim; ++l)
              c[i][j][k][l] =
                q[i][j] * q[k][l] +
                b_t * (b[i][k] * b[j][l] + b[i][l] * b[j][k]) +
                2. * along() * a[i] * a[j] * a[k] * a[l] +
                0.5 * shear() *
                  (b[i][k] * a[j] * a[l] + b[i][l] * a[j] * a[k] +
                   b[j][k] * a[i] * a[l] + b[j][l] * a[i] * a[k]);
      return 0.5 * C * std::exp(exponent(strain)) * c;
    }

  private:
    // The coefficients of E_ff^2 and of |E f|^2.
    double
    along() const
    {
      return b_f - 2. * b_fs + b_t;
    }

    double
    shear() const
    {
      return 2. * (b_fs - b_t);
    }

    // Q.
    double
    exponent(const IsochoricStrain &strain) const
    {
      const Tensor<1, dim>         &a = strain.fibres[0];
      const SymmetricTensor<2, dim> e =
        strain.bbar - dealii::unit_symmetric_tensor<dim>();
      const double E_ff = 0.5 * (a * a - 1.);
      return 0.25 * b_t * (e * e) + along() * E_ff * E_ff +
             0.25 * shear() * (a * (strain.bbar * a) - 2. * (a * a) + 1.);
    }

    // Fbar_e dQ/dE Fbar_e^T.
    SymmetricTensor<2, dim>
    slope(const IsochoricStrain &strain) const
    {
      const SymmetricTensor<2, dim> &b = strain.bbar;
      const Tensor<1, dim>          &a = strain.fibres[0];
      const Tensor<2, dim>           B(b);
      return b_t * (dealii::symmetrize(B * B) - b) +
             along() * (a * a - 1.) *
               dealii::symmetrize(dealii::outer_product(a, a)) +
             shear() * dealii::symmetrize(dealii::outer_product(b * a - a, a));
    }

    double             C    = 0.002;
    double             b_f  = 8.;
    double             b_t  = 2.;
    double             b_fs = 4.;
    Choice<FibreField> fibres;
  };

  static const Register<MaterialLaw, Guccione>
    guccione("Guccione",
             "W = C/2 (exp(Q) - 1), Q quadratic in the strain and stiffer along "
             "fibres, for the muscle of the heart.");
} // namespace lumbricus
