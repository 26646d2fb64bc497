// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_activation_activation_h
#define lumbricus_activation_activation_h

#include <lumbricus/core/dimension.h>
#include <lumbricus/geometry/part_of_body.h>

#include <deal.II/base/point.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace lumbricus
{
  class HeldValues;

  /**
   * How active a muscle is over time, as its MuscleAction takes it: an active
   * stretch lambda, 1 at rest and less in a contraction, or something else.
   */
  class Activation : public PartOfBody
  {
  public:
    /**
     * What its values mean, before its parameters are declared: that of a
     * muscle at rest, and that of one that contracts as much as a muscle can.
     * By default those of an active stretch, 1 and 0.
     */
    void
    set_scale(const double at_rest, const double contracted)
    {
      rest = at_rest;
      full = contracted;
    }

    /**
     * The activation at reference position @p X of segment @p segment (counted
     * from one, as users do) at time @p t. The caller checks the range.
     */
    virtual double
    value(const double              t,
          const unsigned int        segment,
          const dealii::Point<dim> &X) const = 0;

    /**
     * The times between @p from and @p to at which a load step must not look
     * past segment @p segment: where a pulse begins, peaks and ends. Without
     * any, load steps find the changes of value() that take longer than
     * 'Time/Smallest step'.
     */
    virtual std::vector<double>
    marks(const unsigned int /*segment*/,
          const double /*from*/,
          const double /*to*/) const
    {
      return {};
    }

    /**
     * Look at numbers that are given as they are, as in a table, before a run:
     * @p requirement says what a number has to be where it is not that, and
     * nothing where it is. Throws ExcInput that names the place of the first one
     * that is wrong.
     */
    virtual void
    check_given(
      const std::function<std::string(double)> & /*requirement*/) const
    {}

    /** What a Continuation sets before every load step, where values come from
     * outside while the run goes on and are not known before; else null. After
     * initialize(). */
    virtual std::shared_ptr<HeldValues>
    held_values() const
    {
      return nullptr;
    }

  protected:
    /** The value of a muscle that contracts by @p part: 0 is rest, 1 as much as
     * a muscle can. For a pattern that does for every MuscleAction. */
    double
    contracted_by(const double part) const
    {
      return rest + (full - rest) * part;
    }

  private:
    double rest = 1.;
    double full = 0.;
  };
} // namespace lumbricus

#endif
