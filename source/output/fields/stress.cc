// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/output/field.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lumbricus
{
  /** The Cauchy stress sigma = P F^T / J [N/mm^2]. */
  class CauchyStress : public TensorField
  {
  public:
    dealii::Tensor<2, dim>
    value(const FieldPoint &point) const override
    {
      return point.sigma;
    }

    unsigned int
    place() const override
    {
      return 2;
    }
  };

  static const Register<Field, CauchyStress>
    stress_field("cauchy_stress", "sigma [N/mm^2].");



  /** How far the liquid is from hydrostatic, |dev sigma| / |tr sigma / 3|; 0
   * elsewhere. */
  class HydrostaticDivergence : public ScalarField
  {
  public:
    double
    value(const FieldPoint &point) const override
    {
      return point.is_liquid ?
               dealii::deviator(point.sigma).norm() /
                 std::max(std::abs(point.pressure),
                          std::numeric_limits<double>::min()) :
               0.;
    }

    unsigned int
    place() const override
    {
      return 4;
    }
  };

  static const Register<Field, HydrostaticDivergence>
    hydrostatic_divergence("hydrostatic_divergence",
                           "|dev sigma| / |p| in the liquid.");
} // namespace lumbricus
