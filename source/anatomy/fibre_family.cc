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



  ExponentialEnergy
  FibreFamily::stiffening(const ReferencePoint &reference) const
  {
    return {reference.J_v * k1, k2};
  }



  double
  FibreFamily::energy(const Tensor<2, dim> &F,
                      const ReferencePoint &reference,
                      const Tensor<1, dim> &fibre) const
  {
    const double E =
      dealii::symmetrize(transpose(F) * F) * structure(reference, fibre) - 1.;
    return E <= 0. ? 0. : stiffening(reference).value(E);
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
    stiffening(reference).add_stress(F, M, E, with_tangent, response);
  }
} // namespace lumbricus
