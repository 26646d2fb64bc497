// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/numbers.h>
#include <deal.II/base/patterns.h>
#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>

#include "round_obstacle.h"

namespace lumbricus
{
  /**
   * All that is outside of a pipe of the radius R(t): with the point c of its
   * middle line that is nearest to x, and m = (x - c)/|x - c|,
   *
   *   g = R - |x - c|,   n = -m,
   *   H = -(b x b)/|x - c| - k (m . e)/(1 + k (x - c) . e) a x a,
   *
   * where a is the direction of the middle line at c, b = a x m, k its curvature
   * and e the direction away from the centre of its circle.
   */
  class Burrow : public RoundObstacle
  {
  public:
    Burrow()
      : RoundObstacle("Point",
                      "0; 0; 0",
                      "[mm] Three expressions in the time t, separated by "
                      "semicolons: a point of the middle line.")
    {}

    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      RoundObstacle::declare_parameters(prm);
      const dealii::Patterns::List three(dealii::Patterns::Double(), dim, dim);
      prm.add_parameter("Axis",
                        axis,
                        "[x, y, z] A vector along the middle line at 'Point', of "
                        "any length but zero.",
                        three);
      prm.add_parameter("Curvature",
                        curvature,
                        "[1/mm] Of the middle line, a circle; 0 for a straight "
                        "one.",
                        dealii::Patterns::Double(0.));
      prm.add_parameter("Bends towards",
                        towards,
                        "[x, y, z] A vector from 'Point' towards the side where "
                        "the centre of the circle is.",
                        three);
    }

    void
    check_parameters() const override
    {
      AssertThrow(axis.norm() > 0.,
                  ExcParameter("Axis",
                               "has no direction, because its length is zero. "
                               "Give a vector like '1, 0, 0'."));
      AssertThrow(curvature == 0. || inwards().norm() > 0.,
                  ExcParameter("Bends towards",
                               "is along 'Axis'. Give a vector across it."));
      AssertThrow(curvature == 0. || !radius.depends_on_time(),
                  ExcParameter("Radius",
                               "changes in time, but a burrow with a 'Curvature' "
                               "has a constant one."));
    }

    Distance
    distance(const dealii::Point<dim> &x, const LoadTime &t) const override
    {
      const dealii::Point<dim> P = value(place, t);
      dealii::Tensor<1, dim>   a = along();
      dealii::Tensor<1, dim>   to_axis, e;
      if (curvature == 0.)
        to_axis = (x - P) - ((x - P) * a) * a;
      else
        {
          // In the plane of the circle, e points from its centre to x.
          const auto in     = inwards() / inwards().norm();
          const auto centre = P + in / curvature;
          const auto up     = dealii::cross_product_3d(a, in);
          e                 = (x - centre) - ((x - centre) * up) * up;
          e /= e.norm();
          to_axis = (x - centre) - e / curvature;
          a       = dealii::cross_product_3d(e, up);
        }
      const double r = to_axis.norm();
      Distance     found;
      found.gap = value(radius, t) - r;
      // On the middle line there is no direction out.
      if (r == 0.)
        return found;
      const auto m = to_axis / r;
      const auto b = dealii::cross_product_3d(a, m);
      found.n      = -m;
      found.H      = -dealii::outer_product(b, b) / r;
      if (curvature > 0.)
        found.H -= curvature * (m * e) / (1. + curvature * (to_axis * e)) *
                   dealii::outer_product(a, a);
      return found;
    }

    Frame
    frame(const LoadTime &t) const override
    {
      const auto             a     = along();
      const auto             aa = dealii::outer_product(a, a);
      dealii::Tensor<2, dim> one = dealii::unit_symmetric_tensor<dim, double>();
      return {value(place, t), aa + value(radius, t) * (one - aa)};
    }

    Surface
    surface(const LoadTime                 &t,
            const dealii::BoundingBox<dim> &box,
            const double                    spacing) const override
    {
      constexpr int n_around = 48;
      const auto    P        = value(place, t);
      const double  R        = value(radius, t);
      const auto    a        = along();
      const auto    wall =
        [&](const auto &c, const auto &e, const auto &b, const int j) {
          const double phi = 2. * dealii::numbers::PI * j / n_around;
          return dealii::Point<dim>(
            c + R * (std::cos(phi) * e + std::sin(phi) * b));
        };
      if (curvature == 0.)
        {
          const auto e_0 = dealii::Point<dim>::unit_vector(
            std::abs(a[1]) < 0.9 ? 1 : 2);
          const auto across = e_0 - (e_0 * a) * a;
          const auto e      = across / across.norm();
          const auto b      = dealii::cross_product_3d(a, e);
          const auto rings  = range_around(
            box, [&](const auto &x) { return (x - P) * a; }, spacing);
          return grid(rings, {0, n_around}, [&](const int i, const int j) {
            return wall(P + i * spacing * a, e, b, j);
          });
        }
      // By the angle around the centre of the circle, zero at P, and once
      // around at most.
      const auto   in     = inwards() / inwards().norm();
      const auto   up     = dealii::cross_product_3d(a, in);
      const auto   centre = P + in / curvature;
      const double angle  = spacing * curvature;
      auto         rings  = range_around(
        box,
        [&](const auto &x) {
          return std::atan2((x - centre) * a, -((x - centre) * in));
        },
        angle);
      const int half = std::ceil(dealii::numbers::PI / angle);
      rings.first    = std::max(rings.first, -half);
      rings.last     = std::min(rings.last, half);
      return grid(rings, {0, n_around}, [&](const int i, const int j) {
        const auto e = std::sin(i * angle) * a - std::cos(i * angle) * in;
        return wall(centre + e / curvature, e, -up, j);
      });
    }

  private:
    // Of the middle line at 'Point'.
    dealii::Tensor<1, dim>
    along() const
    {
      return axis / axis.norm();
    }

    // Across the axis.
    dealii::Tensor<1, dim>
    inwards() const
    {
      const auto a = along();
      return towards - (towards * a) * a;
    }

    dealii::Tensor<1, dim> axis    = dealii::Point<dim>(1., 0., 0.);
    dealii::Tensor<1, dim> towards = dealii::Point<dim>(0., 0., 1.);
    double                 curvature = 0.;
  };

  static const Register<Obstacle, Burrow>
    burrow("burrow", "the wall of a pipe that the body is in.");
} // namespace lumbricus
