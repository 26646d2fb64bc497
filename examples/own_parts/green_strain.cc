// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/output/field.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

namespace
{
  using lumbricus::dim;

  /** The strain of Green and Lagrange, E = (F^T F - I) / 2. */
  class GreenStrain : public lumbricus::TensorField
  {
  public:
    dealii::Tensor<2, dim>
    value(const lumbricus::FieldPoint &point) const override
    {
      const dealii::Tensor<2, dim> I = dealii::unit_symmetric_tensor<dim>();
      return 0.5 * (transpose(point.F) * point.F - I);
    }
  };

  // The name is that of the array in the VTU files.
  const lumbricus::Register<lumbricus::Field, GreenStrain>
    green_strain("green_strain", "E = (F^T F - I) / 2.");
} // namespace
