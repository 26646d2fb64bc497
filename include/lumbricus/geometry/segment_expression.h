// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_segment_expression_h
#define lumbricus_geometry_segment_expression_h

#include <lumbricus/core/load_time.h>
#include <lumbricus/geometry/geometry.h>
#include <lumbricus/parameters/expression.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * An Expression that may also have the number s of the segment, from 1 at the
   * head, and the number n of segments: a type of parameters.
   */
  class SegmentExpression
  {
  public:
    /** As of Expression. Throws ExcParameter where @p formula does not parse. */
    SegmentExpression(const std::string &entry, const std::string &formula);

    /** As Expression::declare_parameter(). */
    void
    declare_parameter(dealii::ParameterHandler &prm,
                      const std::string        &documentation);

    /** When all has been read: for the segments of @p geometry. */
    void
    initialize(const Geometry &geometry);

    /** That of segment @p segment, from zero, with its s. */
    const Expression &
    of(const unsigned int segment) const;

    /** The middle of that segment at rest, on the axis: x, y and z of what
     * belongs to a segment as a whole. */
    const dealii::Point<dim> &
    middle(const unsigned int segment) const;

    /** The value of segment @p segment, from zero, in its middle, taken at
     * @p t; @p at_rest where nothing acts. See Expression::value(). */
    double
    value(const unsigned int segment,
          const LoadTime    &t,
          const double       at_rest = 0.) const;

    /** "is 0 N/mm^2 for segment 2 at time 0.5", for messages. */
    std::string
    value_text(const unsigned int segment,
               const double       t,
               const std::string &unit = "") const;

    /** The name of the parameter in its section. */
    const std::string &
    parameter() const
    {
      return formula.parameter();
    }

    /** Whether it is but a number, the same for all segments and times. */
    bool
    is_number() const;

    /** Whether t, x, y or z is in it. */
    bool
    depends_on_place_or_time() const
    {
      return formula.depends_on_place() || formula.depends_on_time();
    }

    /** Whether t is in it. */
    bool
    depends_on_time() const
    {
      return formula.depends_on_time();
    }

    /** The formula as the user wrote it. */
    const std::string &
    text() const
    {
      return formula.formula();
    }

  private:
    Expression                      formula;
    std::vector<Expression>         of_segments;
    std::vector<dealii::Point<dim>> middles;
  };
} // namespace lumbricus

#endif
