// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_activation_activation_h
#define lumbricus_activation_activation_h

#include <lumbricus/core/dimension.h>
#include <lumbricus/core/parameter_owner.h>

#include <deal.II/base/point.h>

namespace lumbricus
{
  /**
   * The active stretch lambda of a muscle along its fibres: the stretch at
   * which the muscle is free of stress. lambda < 1 is a contraction.
   */
  class Activation : public ParameterOwner
  {
  public:
    /**
     * Called once before the first value(), with the name of the muscle, for
     * messages, and the number of segments in the chain. Throws ExcInput (an
     * expression that does not parse).
     */
    virtual void
    initialize(const std::string & /*muscle*/,
               const unsigned int /*n_segments*/)
    {}

    /**
     * lambda at reference position @p X of segment @p segment (counted from
     * one, as users do) at time @p t. The caller checks the range.
     */
    virtual double
    value(const double              t,
          const unsigned int        segment,
          const dealii::Point<dim> &X) const = 0;
  };
} // namespace lumbricus

#endif
