// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/adaptivity/jump_estimator.h>
#include <lumbricus/parameters/registry.h>

namespace lumbricus
{
  /** G = P: what jumps is the traction P N, out of balance at a face. */
  class StressJump : public JumpEstimator
  {
  public:
    dealii::Tensor<2, dim>
    flux(const double /*mu*/,
         const dealii::Tensor<2, dim> & /*F*/,
         const dealii::Tensor<2, dim> &P) const override
    {
      return P;
    }

    bool
    continuous_between_tissues() const override
    {
      return true;
    }
  };



  static const Register<ErrorEstimator, StressJump>
    stress_jump("stress jump",
                "by the jumps of the traction between cells, which equilibrium "
                "does not allow.");
} // namespace lumbricus
