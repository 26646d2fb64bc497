// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_fibres_tensor_fit_h
#define lumbricus_fibres_tensor_fit_h

#include <lumbricus/core/dimension.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace lumbricus
{
  /** A sample of a tensor field. */
  struct TensorSample
  {
    dealii::Tensor<1, dim>          x;      ///< where it is, from where it is wanted
    dealii::SymmetricTensor<2, dim> A;      ///< its value
    double                          weight; ///< > 0
  };

  /** What a fit has found at x = 0. */
  struct FittedTensor
  {
    /** The value. */
    dealii::SymmetricTensor<2, dim> A;
    /** By how much it may be off, see fit_tensor(). */
    double error;
    /** Along how many axes the samples say how it changes. */
    unsigned int n_directions = 0;
  };

  /**
   * The value at x = 0 of the linear function that fits @p samples best, as
   * DirectionSamples says. Of a field with second derivatives the rest of the fit at
   * a sample, that is so far from the samples' centre c as rho, is rho^2 times half
   * of them. So with k the mean of rest over the mean of rho^2 its error is
   *
   *   3 k (|c| + s)^2,   s^2 the mean of rho^2 with weights,
   *
   * or less: 3 since the mean of the rest falls short of the largest. Samples are apart
   * along an axis if at least @p least_part of their squared distances along it is not
   * that of a curved surface.
   */
  FittedTensor
  fit_tensor(const std::vector<TensorSample> &samples,
             const double                     least_part = 0.03);
} // namespace lumbricus

#endif
