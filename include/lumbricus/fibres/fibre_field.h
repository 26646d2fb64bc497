// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_fibres_fibre_field_h
#define lumbricus_fibres_fibre_field_h

#include <lumbricus/core/dimension.h>
#include <lumbricus/geometry/part_of_body.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

namespace lumbricus
{
  /** Unit vectors along the fibres of a muscle, in the reference configuration.
   */
  class FibreField : public PartOfBody
  {
  public:
    /**
     * The unit vector f(X). Throws ExcInput where the field has no direction
     * at @p X (on the axis of a circumferential one), naming the point.
     */
    virtual dealii::Tensor<1, dim>
    direction(const dealii::Point<dim> &X) const = 0;

    /** Whether there are directions at some points only, and direction() is
     * that of the nearest of them. */
    virtual bool
    is_sampled() const
    {
      return false;
    }
  };
} // namespace lumbricus

#endif
