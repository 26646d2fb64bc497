// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_terms_boundary_condition_h
#define lumbricus_terms_boundary_condition_h

#include <lumbricus/geometry/part_of_body.h>
#include <lumbricus/parameters/expression.h>

#include <vector>

namespace lumbricus
{
  /**
   * What users name for a part of the boundary. By itself it does nothing: a
   * SurfaceTerm pulls, a PrescribedDisplacement holds, and a class that is
   * derived from both does both.
   */
  class BoundaryCondition : public PartOfBody
  {
  public:
    /** All expressions, tried at the start over the time of the run. Those of a
     * SurfaceTerm are looked at between load steps too. */
    virtual std::vector<Expression>
    expressions() const
    {
      return {};
    }

    /** Whether what they say is there before the first load, as it is at time
     * zero: so it is with obstacles, not with loads, which are zero then. */
    virtual bool
    is_there_at_rest() const
    {
      return false;
    }
  };
} // namespace lumbricus

#endif
