// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/output/field.h>
#include <lumbricus/parameters/registry.h>

namespace lumbricus
{
  /** The volume over that at rest, J = det F. */
  class VolumeRatio : public ScalarField
  {
  public:
    double
    value(const FieldPoint &point) const override
    {
      return point.J;
    }

    unsigned int
    place() const override
    {
      return 3;
    }
  };

  static const Register<Field, VolumeRatio> volume_ratio("J", "det F.");
} // namespace lumbricus
