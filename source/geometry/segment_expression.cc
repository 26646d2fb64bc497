// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/number_in_text.h>
#include <lumbricus/geometry/segment_expression.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/utilities.h>

#include <string>

namespace lumbricus
{
  SegmentExpression::SegmentExpression(const std::string &entry,
                                       const std::string &formula)
    : formula(entry, formula, {{"s", 1.}, {"n", 1.}})
  {}



  void
  SegmentExpression::declare_parameter(dealii::ParameterHandler &prm,
                                       const std::string &documentation)
  {
    formula.declare_parameter(prm, documentation);
  }



  void
  SegmentExpression::initialize(const Geometry &geometry)
  {
    // s and n are constants to a parser, so each segment has its own.
    const auto         sections = geometry.sections();
    const unsigned int n        = sections.size();
    of_segments.clear();
    of_segments.reserve(n);
    middles.assign(n, dealii::Point<dim>());
    for (unsigned int s = 0; s < n; ++s)
      {
        of_segments.push_back(
          formula.with({{"s", s + 1.}, {"n", double(n)}}));
        middles[s][0] = sections[s].middle;
      }
  }



  const Expression &
  SegmentExpression::of(const unsigned int segment) const
  {
    AssertIndexRange(segment, of_segments.size());
    return of_segments[segment];
  }



  const dealii::Point<dim> &
  SegmentExpression::middle(const unsigned int segment) const
  {
    AssertIndexRange(segment, middles.size());
    return middles[segment];
  }



  bool
  SegmentExpression::is_number() const
  {
    double value;
    return read_number(text(), value);
  }



  double
  SegmentExpression::value(const unsigned int segment,
                           const LoadTime    &t,
                           const double       at_rest) const
  {
    return t.take(
      [&](const double time) { return of(segment).value(middle(segment), time); },
      at_rest);
  }



  std::string
  SegmentExpression::value_text(const unsigned int segment,
                                const double       t,
                                const std::string &unit) const
  {
    return "is " + dealii::Utilities::to_string(value(segment, t)) +
           (unit.empty() ? "" : " " + unit) + " for segment " +
           std::to_string(segment + 1) + " at time " +
           dealii::Utilities::to_string(t);
  }
} // namespace lumbricus
