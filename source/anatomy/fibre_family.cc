// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/anatomy/fibre_family.h>
#include <lumbricus/parameters/patterns.h>

#include <cmath>

namespace lumbricus
{
  using dealii::SymmetricTensor;
  using dealii::Tensor;

  FibreFamily::FibreFamily(const std::string &name)
    : fibre_choice("Fibres",
                   "",
                   "The direction of the fibres at rest.",
                   Placement::own_section,
                   ": the family of fibres '" + name + "' has no direction")
  {}



  void
  FibreFamily::declare_parameters(dealii::ParameterHandler &prm)
  {
    fibre_choice.declare_parameters(prm);
    prm.add_parameter("k1",
                      k1,
                      "[N/mm^2] Stiffness: of the energy k1/(2 k2) (exp(k2 E^2) "
                      "- 1), E = kappa (I1 - 3) + (1 - 3 kappa) (I4 - 1), where "
                      "E > 0.",
                      PositiveNumber());
    prm.add_parameter("k2",
                      k2,
                      "[-] How fast they stiffen; 0: the energy is k1/2 E^2.",
                      dealii::Patterns::Double(0., 1e100));
    prm.add_parameter("kappa",
                      kappa,
                      "[-] Dispersion: 0 for fibres all along one direction, 1/3 "
                      "for as many in all directions.",
                      dealii::Patterns::Double(0., 1. / 3.));
  }



  bool
  FibreFamily::extend_parameters(dealii::ParameterHandler &prm,
                                 const Extent              extent)
  {
    return fibre_choice.extend_parameters(prm, extent);
  }



  void
  FibreFamily::check_parameters() const
  {
    fibre_choice.check_parameters();
  }



  void
  FibreFamily::initialize(const std::string &section, const Geometry &geometry)
  {
    fibre_choice.get()->initialize(fibre_choice.section_in(section), geometry);
  }



  bool
  FibreFamily::is_as_stiff_as(const FibreFamily &other) const
  {
    return k1 == other.k1 && k2 == other.k2 && kappa == other.kappa;
  }



  SymmetricTensor<2, dim>
  FibreFamily::structure(const ReferencePoint &reference,
                         const Tensor<1, dim> &fibre) const
  {
    const double          J_v_2_3 = std::pow(reference.J_v, 2. / dim);
    const Tensor<2, dim> &H       = reference.G_inverse;
    const Tensor<1, dim>  f       = H * fibre / fibre.norm();
    return dealii::symmetrize(kappa / J_v_2_3 * H * dealii::transpose(H) +
                              (1. - 3. * kappa) / J_v_2_3 *
                                dealii::outer_product(f, f));
  }



  double
  FibreFamily::energy(const Tensor<2, dim> &F,
                      const ReferencePoint &reference,
                      const Tensor<1, dim> &fibre) const
  {
    const double E =
      dealii::symmetrize(transpose(F) * F) * structure(reference, fibre) - 1.;
    if (E <= 0.)
      return 0.;
    return reference.J_v * k1 *
           (k2 == 0. ? 0.5 * E * E : std::expm1(k2 * E * E) / (2. * k2));
  }



  void
  FibreFamily::add_stress(const Tensor<2, dim> &F,
                          const ReferencePoint &reference,
                          const Tensor<1, dim> &fibre,
                          const bool            with_tangent,
                          MaterialResponse     &response) const
  {
    const SymmetricTensor<2, dim> M = structure(reference, fibre);
    const double E = dealii::symmetrize(transpose(F) * F) * M - 1.;
    if (E <= 0.)
      return;
    const double         growth = reference.J_v * k1 * std::exp(k2 * E * E);
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
