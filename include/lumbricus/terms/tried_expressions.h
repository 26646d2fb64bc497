// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_terms_tried_expressions_h
#define lumbricus_terms_tried_expressions_h

#include <lumbricus/core/dimension.h>
#include <lumbricus/core/load_curve.h>
#include <lumbricus/parameters/expression.h>

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * Why the values of @p expressions of a section cannot be used at @p points,
   * of which only some are tried where there are many, and @p times: one is NaN
   * or infinite. Empty where they can. @p where they have to be finite, for the
   * message.
   */
  std::string
  value_that_is_not_finite(const std::string                     &section,
                           const std::vector<Expression>         &expressions,
                           const std::vector<dealii::Point<dim>> &points,
                           const std::vector<double>             &times,
                           const std::string                     &where);

  /** What @p expression of the section @p section is at @p points over time. */
  LoadCurve
  curve_of(const std::string                     &section,
           const Expression                      &expression,
           const std::vector<dealii::Point<dim>> &points);
} // namespace lumbricus

#endif
