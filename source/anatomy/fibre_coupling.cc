// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/anatomy/exponential_energy.h>
#include <lumbricus/anatomy/fibre_coupling.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/user_text.h>
#include <lumbricus/parameters/patterns.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>

namespace lumbricus
{
  using dealii::SymmetricTensor;
  using dealii::Tensor;

  namespace
  {
    // E = F^T F : M - I8_0.
    struct Shear
    {
      Shear(const Tensor<2, dim> &F,
            const ReferencePoint &reference,
            const Tensor<1, dim> &f,
            const Tensor<1, dim> &s)
      {
        const double          size = f.norm() * s.norm();
        const Tensor<2, dim> &H    = reference.G_inverse;
        M = std::pow(reference.J_v, -2. / dim) / size *
            dealii::symmetrize(dealii::outer_product(H * f, H * s));
        E = dealii::symmetrize(transpose(F) * F) * M - f * s / size;
      }

      SymmetricTensor<2, dim> M;
      double                  E;
    };
  } // namespace



  FibreCoupling::FibreCoupling(const std::string &name)
    : coupling_name(name)
  {}



  void
  FibreCoupling::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.add_parameter("Between",
                      between,
                      "[names] The two families of elastic fibres that it holds "
                      "at their angle, separated by a comma.",
                      NameList());
    prm.add_parameter("a",
                      a,
                      "[N/mm^2] Stiffness: of the energy a/(2 b) (exp(b E^2) - "
                      "1), E = I8 - its value at rest, where I8 = (F f) . (F s) "
                      "and f and s are unit vectors along the two families.",
                      PositiveNumber());
    prm.add_parameter("b",
                      b,
                      "[-] How fast it stiffens; 0: the energy is a/2 E^2.",
                      dealii::Patterns::Double(0., 1e100));
  }



  void
  FibreCoupling::find_families(const std::string              &section,
                               const std::vector<std::string> &families)
  {
    const auto wrong = [&](const std::string &what) {
      return ExcInput(about_parameter(section + "/" + coupling_name + "/Between",
                                      what));
    };
    AssertThrow(between.size() == 2,
                wrong("has " + std::to_string(between.size()) +
                      " names; it takes those of two families of 'Elastic "
                      "fibres'."));
    AssertThrow(between[0] != between[1],
                wrong("has '" + between[0] +
                      "' twice; it takes two different families."));
    for (unsigned int i = 0; i < 2; ++i)
      {
        const auto found =
          std::find(families.begin(), families.end(), between[i]);
        AssertThrow(found != families.end(),
                    wrong("has '" + between[i] +
                          "', which is none of the tissue's 'Elastic fibres'. "
                          "Name it in 'Elastic fibres/Names'."));
        places[i] = found - families.begin();
      }
  }



  bool
  FibreCoupling::is_as_stiff_as(const FibreCoupling &other) const
  {
    return a == other.a && b == other.b;
  }



  double
  FibreCoupling::energy(const Tensor<2, dim> &F,
                        const ReferencePoint &reference,
                        const Tensor<1, dim> &f,
                        const Tensor<1, dim> &s) const
  {
    return ExponentialEnergy{reference.J_v * a, b}.value(
      Shear(F, reference, f, s).E);
  }



  void
  FibreCoupling::add_stress(const Tensor<2, dim> &F,
                            const ReferencePoint &reference,
                            const Tensor<1, dim> &f,
                            const Tensor<1, dim> &s,
                            const bool            with_tangent,
                            MaterialResponse     &response) const
  {
    const Shear shear(F, reference, f, s);
    ExponentialEnergy{reference.J_v * a, b}.add_stress(
      F, shear.M, shear.E, with_tangent, response);
  }
} // namespace lumbricus
