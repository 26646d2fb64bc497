// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/terms/tried_expressions.h>

#include <cmath>
#include <sstream>

namespace lumbricus
{
  std::string
  value_that_is_not_finite(const std::string                     &section,
                           const std::vector<Expression>         &expressions,
                           const std::vector<dealii::Point<dim>> &points,
                           const std::vector<double>             &times,
                           const std::string                     &where)
  {
    // Not more of them than take no time.
    constexpr std::size_t most_points = 200;
    const std::size_t     stride      = 1 + points.size() / most_points;
    for (const Expression &expression : expressions)
      for (std::size_t i = 0; i < points.size(); i += stride)
        for (const double t : times)
          {
            const double value = expression.value(points[i], t);
            if (std::isfinite(value))
              continue;
            std::ostringstream message;
            message << ": the expression '" << expression.formula() << "' is "
                    << value << " at time " << t
                    << ", X = " << point_text(points[i])
                    << ". Change it so that it is a number " << where
                    << " from time 0 to the end.";
            return about_parameter(section + "/" + expression.parameter(),
                                   message.str());
          }
    return "";
  }



  LoadCurve
  curve_of(const std::string                     &section,
           const Expression                      &expression,
           const std::vector<dealii::Point<dim>> &points)
  {
    LoadCurve curve;
    curve.what = "'" + section + "/" + expression.parameter() + "'";
    for (const dealii::Point<dim> &X : points)
      curve.values.push_back(
        [expression, X](const double t) { return expression.value(X, t); });
    return curve;
  }
} // namespace lumbricus
