// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/output/field.h>
#include <lumbricus/parameters/registry.h>

#include <string>

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
      const MuscleFibre *const here = point.fibre();
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



  /** What a muscle's activation is, named after that, as
   * "active_stretch_outer"; where it has no fibres what it is at rest. */
  class ActivationOfMuscle : public ScalarField
  {
  public:
    double
    value(const FieldPoint &point) const override
    {
      const MuscleFibre *const here = point.fibre();
      return here == nullptr ? point.muscle->action().at_rest() :
                               here->activation;
    }

    std::string
    array_name(const std::string & /*name*/, const Muscle &muscle) const override
    {
      return muscle.activation_field_name();
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

  static const Register<Field, ActivationOfMuscle>
    activation_of_muscle("activation",
                         "that of every muscle: 'active_stretch' or, of one "
                         "that pulls, 'activation', and its name.");
} // namespace lumbricus
