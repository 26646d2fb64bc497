// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/contact/obstacle.h>

#include <deal.II/base/geometry_info.h>

#include <algorithm>
#include <cmath>
#include <limits>

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



  Obstacle::Surface
  Obstacle::grid(
    const Range                                                   &rows,
    const Range                                                   &columns,
    const std::function<dealii::Point<dim>(const int, const int)> &place)
  {
    Surface            surface;
    const unsigned int n = columns.last - columns.first + 1;
    for (int i = rows.first; i <= rows.last; ++i)
      for (int j = columns.first; j <= columns.last; ++j)
        {
          const unsigned int here = surface.points.size();
          surface.points.push_back(place(i, j));
          if (i < rows.last && j < columns.last)
            surface.quads.push_back({{here, here + n, here + n + 1, here + 1}});
        }
    return surface;
  }



  Obstacle::Range
  Obstacle::range_around(
    const dealii::BoundingBox<dim> &box,
    const std::function<double(const dealii::Point<dim> &)> &coordinate,
    const double                                             spacing)
  {
    double low  = std::numeric_limits<double>::max();
    double high = -low;
    for (unsigned int v = 0; v < dealii::GeometryInfo<dim>::vertices_per_cell;
         ++v)
      {
        const double x = coordinate(box.vertex(v));
        low            = std::min(low, x);
        high           = std::max(high, x);
      }
    // One more on each side, and not without an end.
    constexpr double most = 500., farthest = 1e8;
    const double     middle =
      std::clamp(0.5 * (low + high) / spacing, -farthest, farthest);
    const double half = std::min(0.5 * (high - low) / spacing, most);
    return {static_cast<int>(std::floor(middle - half)) - 1,
            static_cast<int>(std::ceil(middle + half)) + 1};
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
