// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>

#include "round_obstacle.h"

namespace lumbricus
{
  /** A ball, g = |x - x_0(t)| - R(t), with n = (x - x_0)/|x - x_0| and
   * H = (I - n x n)/|x - x_0|. */
  class Sphere : public RoundObstacle
  {
  public:
    Sphere()
      : RoundObstacle("Centre",
                      "0; 0; -1",
                      "[mm] Three expressions in the time t, separated by "
                      "semicolons.")
    {}

    Distance
    distance(const dealii::Point<dim> &x, const LoadTime &t) const override
    {
      const auto   d = x - value(place, t);
      const double r = d.norm();
      Distance     found;
      found.gap = r - value(radius, t);
      // In its very centre there is no direction out.
      found.n = r > 0. ? d / r : dealii::Point<dim>::unit_vector(0);
      if (r > 0.)
        found.H = (dealii::Tensor<2, dim>(
                     dealii::unit_symmetric_tensor<dim, double>()) -
                   dealii::outer_product(found.n, found.n)) /
                  r;
      return found;
    }

    Frame
    frame(const LoadTime &t) const override
    {
      return {value(place, t),
              value(radius, t) *
                dealii::Tensor<2, dim>(
                  dealii::unit_symmetric_tensor<dim, double>())};
    }

    Surface
    surface(const LoadTime                 &t,
            const dealii::BoundingBox<dim> &box,
            const double                    spacing) const override
    {
      // As on a globe, whose poles are along z: what is near the box, or all of
      // it if that is nowhere near.
      const auto   C = value(place, t);
      const double R = value(radius, t);
      const int    n =
        std::clamp(dealii::numbers::PI * R / spacing, 12., 120.);
      const double step  = dealii::numbers::PI / n;
      const auto   on_globe = [&](const int i, const int j) {
        const dealii::Point<dim> m(std::sin(i * step) * std::cos(j * step),
                                   std::sin(i * step) * std::sin(j * step),
                                   std::cos(i * step));
        return C + R * m;
      };
      const Surface            whole  = grid({0, n}, {0, 2 * n}, on_globe);
      dealii::BoundingBox<dim> around = box;
      around.extend(2. * spacing);
      Surface part{whole.points, {}};
      for (const auto &quad : whole.quads)
        if (std::any_of(quad.begin(), quad.end(), [&](const unsigned int p) {
              return around.point_inside(whole.points[p]);
            }))
          part.quads.push_back(quad);
      return part.quads.empty() ? whole : part;
    }
  };

  static const Register<Obstacle, Sphere>
    sphere("sphere", "a ball, with the body outside.");
} // namespace lumbricus
