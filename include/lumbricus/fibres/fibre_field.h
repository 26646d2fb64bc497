// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_fibres_fibre_field_h
#define lumbricus_fibres_fibre_field_h

#include <lumbricus/core/dimension.h>
#include <lumbricus/geometry/part_of_body.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <string>

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

    /** By how much f f may be off at @p X, in the Frobenius norm, where directions
     * are given at some points only. */
    virtual double
    error(const dealii::Point<dim> & /*X*/) const
    {
      return 0.;
    }

    /** What is doubtful about the directions, a sentence or more that begin with
     * the parameter; empty where nothing is. */
    virtual std::string
    warning() const
    {
      return "";
    }
  };
} // namespace lumbricus

#endif
