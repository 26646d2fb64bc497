// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/registry.h>
#include <lumbricus/output/field.h>

namespace lumbricus
{
  /** The unit vector along the deformed fibres of a muscle, F f / |F f|; zero
   * where it has none. */
  class DeformedFibre : public VectorField
  {
  public:
    dealii::Tensor<1, dim>
    value(const FieldPoint &point) const override
    {
      const ActiveFibre *const here = point.fibre();
      if (here == nullptr)
        return dealii::Tensor<1, dim>();
      const dealii::Tensor<1, dim> f = point.F * here->f;
      return f / f.norm();
    }

    bool
    is_per_muscle() const override
    {
      return true;
    }

    unsigned int
    place() const override
    {
      return 5;
    }
  };

  static const Register<Field, DeformedFibre>
    deformed_fibre("fibre", "the deformed direction of every muscle.");



  /** The active stretch lambda of a muscle; 1 where it has no fibres. */
  class ActiveStretch : public ScalarField
  {
  public:
    double
    value(const FieldPoint &point) const override
    {
      const ActiveFibre *const here = point.fibre();
      return here == nullptr ? 1. : here->lambda;
    }

    bool
    is_per_muscle() const override
    {
      return true;
    }

    unsigned int
    place() const override
    {
      return 5;
    }
  };

  static const Register<Field, ActiveStretch>
    active_stretch("active_stretch", "lambda of every muscle.");
} // namespace lumbricus
