// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/adaptivity/jump_estimator.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/symmetric_tensor.h>

namespace lumbricus
{
  /**
   * G = mu Grad u, the estimator of Kelly, Gago, Zienkiewicz and Babuska (Int.
   * J. Numer. Meth. Eng. 19, 1983), weighted by stiffness. It jumps where
   * tissues meet, by what the pressure carries there.
   */
  class DisplacementJump : public JumpEstimator
  {
  public:
    dealii::Tensor<2, dim>
    flux(const double                  mu,
         const dealii::Tensor<2, dim> &F,
         const dealii::Tensor<2, dim> & /*P*/) const override
    {
      return mu * (F - dealii::unit_symmetric_tensor<dim>());
    }

    bool
    continuous_between_tissues() const override
    {
      return false;
    }
  };



  static const Register<ErrorEstimator, DisplacementJump> displacement_jump(
    "displacement jump",
    "by the jumps of the shear modulus times the displacement's gradient "
    "between cells of the same tissue (Kelly).");
} // namespace lumbricus
