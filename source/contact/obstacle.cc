// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/contact/obstacle.h>

namespace lumbricus
{
  dealii::Point<dim>
  Obstacle::carried(const dealii::Point<dim> &x0, const LoadTime &t) const
  {
    const Frame begin = frame(0.), now = frame(t);
    return now.origin + now.axes * (invert(begin.axes) * (x0 - begin.origin));
  }



  dealii::Point<dim>
  Obstacle::carried_back(const dealii::Point<dim> &x, const LoadTime &t) const
  {
    const Frame begin = frame(0.), now = frame(t);
    return begin.origin + begin.axes * (invert(now.axes) * (x - now.origin));
  }



  double
  Obstacle::value(const Expression &formula, const LoadTime &t)
  {
    const dealii::Point<dim> nowhere;
    return t.take(
      [&](const double at) { return formula.value(nowhere, at); },
      formula.value(nowhere, 0.));
  }



  dealii::Point<dim>
  Obstacle::value(const VectorExpression &formulas, const LoadTime &t)
  {
    dealii::Point<dim> x;
    for (unsigned int i = 0; i < dim; ++i)
      x[i] = value(formulas.components()[i], t);
    return x;
  }
} // namespace lumbricus
