// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/output/field.h>
#include <lumbricus/parameters/registry.h>

namespace lumbricus
{
  /** The displacement u [mm]. */
  class Displacement : public VectorField
  {
  public:
    dealii::Tensor<1, dim>
    value(const FieldPoint &point) const override
    {
      return point.u;
    }

    unsigned int
    place() const override
    {
      return 0;
    }
  };

  static const Register<Field, Displacement>
    displacement("displacement", "u [mm].");
} // namespace lumbricus
