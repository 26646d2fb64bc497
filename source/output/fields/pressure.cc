// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/output/field.h>
#include <lumbricus/parameters/registry.h>

namespace lumbricus
{
  /** The mean pressure -tr sigma / 3 [N/mm^2], positive in compression. */
  class MeanPressure : public ScalarField
  {
  public:
    double
    value(const FieldPoint &point) const override
    {
      return point.pressure;
    }

    unsigned int
    place() const override
    {
      return 1;
    }
  };

  static const Register<Field, MeanPressure>
    mean_pressure("pressure", "-tr sigma / 3 [N/mm^2].");



  /** The unknown p of the mixed formulation [N/mm^2], positive in tension. */
  class PressureUnknown : public ScalarField
  {
  public:
    double
    value(const FieldPoint &point) const override
    {
      return point.pressure_unknown;
    }

    unsigned int
    place() const override
    {
      return 6;
    }
  };

  static const Register<Field, PressureUnknown>
    pressure_unknown("pressure_unknown", "the pressure variable p [N/mm^2].");
} // namespace lumbricus
