// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_tests_unit_sample_point_h
#define lumbricus_tests_unit_sample_point_h

#include <lumbricus/core/dimension.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <initializer_list>

namespace lumbricus
{
  /** A point without any symmetry, at which laws and muscles are compared with
   * finite differences. */
  namespace sample_point
  {
    using Gradient = dealii::Tensor<2, dim>;

    /** A deformation gradient from its entries, row by row. */
    inline Gradient
    gradient(const std::initializer_list<double> &entries)
    {
      Gradient F;
      auto     entry = entries.begin();
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int J = 0; J < dim; ++J)
          F[i][J] = *entry++;
      return F;
    }

    /** The deformation gradient there. */
    inline const Gradient F_general =
      gradient({1.3, 0.2, -0.1, 0.15, 0.8, 0.25, -0.3, 0.1, 1.1});

    /** The place. */
    inline const dealii::Point<dim> X(0.1, 0.2, 0.3);

    /** The pressure there. */
    constexpr double p = 0.37;

    /** The step of differences, of F and of p. */
    constexpr double h = 1e-5;
  } // namespace sample_point
} // namespace lumbricus

#endif
