// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_anatomy_viscous_point_h
#define lumbricus_anatomy_viscous_point_h

#include <lumbricus/core/dimension.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

namespace lumbricus
{
  /** Cbar^(-1) = J^(2/3) F^(-1) F^(-T), the inverse of the change of shape. */
  dealii::SymmetricTensor<2, dim>
  inverse_shape(const dealii::Tensor<2, dim> &F);



  /** What a ViscousBranch remembers at a point, by default of a body that has
   * always been at rest. */
  struct ViscousPoint
  {
    /** b_n, that of the end of the last load step. */
    dealii::SymmetricTensor<2, dim> before =
      dealii::unit_symmetric_tensor<dim, double>();
    /** h, what is left of the past at the end of this step. */
    dealii::SymmetricTensor<2, dim> kept =
      dealii::unit_symmetric_tensor<dim, double>();
    /** x = dt/tau, the length of this step; 0 where none is under way. */
    double x = 0.;

    /** b = h + (1 - m) Cbar^(-1) at the end of a step that ends at @p F. */
    dealii::SymmetricTensor<2, dim>
    at_end(const dealii::Tensor<2, dim> &F) const;
  };
} // namespace lumbricus

#endif
