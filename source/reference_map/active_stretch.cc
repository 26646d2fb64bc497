// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/isotropic_function.h>
#include <lumbricus/reference_map/active_stretch.h>

#include <cmath>

namespace lumbricus
{
  using dealii::SymmetricTensor;

  namespace
  {
    SymmetricTensor<2, dim>
    dyad(const dealii::Tensor<1, dim> &f)
    {
      return dealii::symmetrize(dealii::outer_product(f, f));
    }
  } // namespace



  ReferencePoint
  active_stretch_map(const std::vector<ActiveFibre> &fibres)
  {
    const auto     I = dealii::unit_symmetric_tensor<dim, double>();
    ReferencePoint reference;
    for (const ActiveFibre &fibre : fibres)
      reference.J_v *= fibre.volume;
    if (fibres.size() == 1)
      {
        // G^(-1) = 1/lambda f x f + sqrt(lambda) (I - f x f)
        const double lambda = fibres[0].lambda;
        const auto   ff     = dyad(fibres[0].f);
        reference.G_inverse = 1. / lambda * ff + std::sqrt(lambda) * (I - ff);
      }
    else if (fibres.size() > 1)
      {
        SymmetricTensor<2, dim> logarithm;
        for (const ActiveFibre &fibre : fibres)
          logarithm -= std::log(fibre.lambda) * (1.5 * dyad(fibre.f) - 0.5 * I);
        reference.G_inverse =
          isotropic_function(logarithm,
                             [](const double x) { return std::exp(x); });
      }
    return reference;
  }
} // namespace lumbricus
