// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/contact/obstacle.h>
#include <lumbricus/parameters/registry.h>

#include <deal.II/base/symmetric_tensor.h>

#include <cmath>

namespace lumbricus
{
  /** The half space behind a plane, g = (x - x_0(t)) . n(t). */
  class Plane : public Obstacle
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      point.declare_parameter(prm,
                              "[mm] Three expressions in the time t, separated "
                              "by semicolons: a point of the plane.");
      normal.declare_parameter(prm,
                               "[-] Three expressions in the time t: a vector, "
                               "of any length but zero, that points from the "
                               "obstacle to where the body is.");
    }

    std::vector<Expression>
    expressions() const override
    {
      std::vector<Expression> all = point.components();
      all.insert(all.end(),
                 normal.components().begin(),
                 normal.components().end());
      return all;
    }

    std::string
    unfit(const double t) const override
    {
      return value(normal, t).norm() > 0. ?
               "" :
               "'Normal' has no direction, because its length is zero or not a "
               "number";
    }

    Distance
    distance(const dealii::Point<dim> &x, const LoadTime &t) const override
    {
      Distance found;
      found.n   = direction(t);
      found.gap = (x - value(point, t)) * found.n;
      return found;
    }

    Frame
    frame(const LoadTime &t) const override
    {
      return {value(point, t), turned(direction(t))};
    }

    Surface
    surface(const LoadTime                 &t,
            const dealii::BoundingBox<dim> &box,
            const double                    spacing) const override
    {
      // Two directions along the plane, of which the first is along x where
      // that is possible.
      const auto n_0 = direction(0.);
      const auto e =
        dealii::Point<dim>::unit_vector(std::abs(n_0[0]) < 0.9 ? 0 : 1);
      const auto along = e - (e * n_0) * n_0;
      const auto a     = turned(direction(t)) * along / along.norm();
      const auto b     = dealii::cross_product_3d(direction(t), a);
      const auto P     = value(point, t);
      const auto rows  = range_around(
        box, [&](const auto &x) { return (x - P) * a; }, spacing);
      const auto columns = range_around(
        box, [&](const auto &x) { return (x - P) * b; }, spacing);
      return grid(rows, columns, [&](const int i, const int j) {
        return P + spacing * (i * a + j * b);
      });
    }

  private:
    dealii::Tensor<1, dim>
    direction(const LoadTime &t) const
    {
      const dealii::Tensor<1, dim> n = value(normal, t);
      return n / n.norm();
    }

    // The shortest rotation of the normal at time zero to n: I + [v] +
    // [v]^2/(1 + c) with v = n_0 x n and c = n_0 . n, where the two are not
    // opposite.
    dealii::Tensor<2, dim>
    turned(const dealii::Tensor<1, dim> &n) const
    {
      const auto             n_0 = direction(0.);
      const auto             v   = dealii::cross_product_3d(n_0, n);
      dealii::Tensor<2, dim> cross;
      cross[0][1] = -v[2];
      cross[0][2] = v[1];
      cross[1][0] = v[2];
      cross[1][2] = -v[0];
      cross[2][0] = -v[1];
      cross[2][1] = v[0];
      dealii::Tensor<2, dim> R = dealii::unit_symmetric_tensor<dim, double>();
      const double           c = n_0 * n;
      if (c > -1. + 1e-12)
        R += cross + cross * cross / (1. + c);
      return R;
    }

    VectorExpression point  = {"Point", "0; 0; 0"};
    VectorExpression normal = {"Normal", "0; 0; 1"};
  };

  static const Register<Obstacle, Plane>
    plane("plane", "all that is behind a plane, as the ground.");
} // namespace lumbricus
