// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_terms_boundary_condition_h
#define lumbricus_terms_boundary_condition_h

#include <lumbricus/parameters/expression.h>
#include <lumbricus/parameters/parameter_owner.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * What users name for a part of the boundary. By itself it does nothing: a
   * SurfaceTerm pulls, a PrescribedDisplacement holds, and a class that is
   * derived from both does both.
   */
  class BoundaryCondition : public ParameterOwner
  {
  public:
    /**
     * Read the expressions. @param name the full name of the section, for
     * messages. Throws ExcInput.
     */
    virtual void
    initialize(const std::string &name) = 0;

    /** All expressions, tried at the start over the time of the run. Those of a
     * SurfaceTerm are looked at between load steps too. */
    virtual std::vector<Expression>
    expressions() const = 0;
  };
} // namespace lumbricus

#endif
