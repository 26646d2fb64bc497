// SPDX-License-Identifier: LGPL-2.1-or-later
#include "quadratic_cell.h"

#include <deal.II/base/exceptions.h>
#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lumbricus
{
  using dealii::Point;
  using dealii::Tensor;

  namespace
  {
    // Twice the place of each of Gmsh's nodes (its reference manual, 'Node ordering'):
    // corners, edges, faces, the middle.
    constexpr unsigned int gmsh_place[QuadraticCell::n_nodes][3] = {
      {0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2},
      {0, 2, 2}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 1, 0}, {2, 0, 1}, {1, 2, 0},
      {2, 2, 1}, {0, 2, 1}, {1, 0, 2}, {0, 1, 2}, {2, 1, 2}, {1, 2, 2}, {1, 1, 0},
      {1, 0, 1}, {0, 1, 1}, {2, 1, 1}, {1, 2, 1}, {1, 1, 2}, {1, 1, 1}};

    constexpr unsigned int n_serendipity = 20;



    Point<dim>
    place_of(const unsigned int n)
    {
      return Point<dim>(0.5 * (n % 3), 0.5 * (n / 3 % 3), 0.5 * (n / 9));
    }



    // The function of a corner or an edge in the element of 20 nodes.
    double
    serendipity_function(const unsigned int node, const Point<dim> &x)
    {
      double product = 1., sum = -2.;
      for (unsigned int d = 0; d < dim; ++d)
        {
          const double xi   = 2. * x[d] - 1.;
          const double at   = static_cast<double>(gmsh_place[node][d]) - 1.;
          const bool   edge = at == 0.;
          product *= edge ? (1. - xi * xi) : (1. + at * xi) / 2.;
          sum += at * xi;
        }
      return node < 8 ? product * sum : product;
    }



    double
    polynomial(const unsigned int i, const double x)
    {
      return i == 0 ? (2. * x - 1.) * (x - 1.) :
             i == 1 ? 4. * x * (1. - x) :
                      x * (2. * x - 1.);
    }



    double
    derivative(const unsigned int i, const double x)
    {
      return i == 0 ? 4. * x - 3. : i == 1 ? 4. - 8. * x : 4. * x - 1.;
    }
  } // namespace



  QuadraticCell
  QuadraticCell::from_gmsh(const std::vector<Point<dim>> &of_gmsh)
  {
    AssertThrow(of_gmsh.size() == n_nodes || of_gmsh.size() == n_serendipity,
                dealii::ExcInternalError());
    Nodes all;
    for (unsigned int n = 0; n < n_nodes; ++n)
      {
        const auto        &at = gmsh_place[n];
        Point<dim> &X = all[at[0] + 3 * at[1] + 9 * at[2]];
        if (n < of_gmsh.size())
          X = of_gmsh[n];
        else
          for (unsigned int m = 0; m < n_serendipity; ++m)
            X += serendipity_function(
                   m, Point<dim>(0.5 * at[0], 0.5 * at[1], 0.5 * at[2])) *
                 of_gmsh[m];
      }
    return QuadraticCell(all);
  }



  QuadraticCell::QuadraticCell(const Nodes &nodes)
    : nodes(nodes)
  {}



  void
  QuadraticCell::scale(const double factor)
  {
    for (Point<dim> &X : nodes)
      X *= factor;
  }



  std::array<Point<dim>, QuadraticCell::n_face_nodes>
  QuadraticCell::face_nodes(const unsigned int f) const
  {
    std::array<Point<dim>, n_face_nodes> result;
    for (unsigned int a = 0; a < n_face_nodes; ++a)
      {
        std::array<unsigned int, dim> i;
        i[f / 2]             = 2 * (f % 2);
        i[(f / 2 + 1) % dim] = a % 3;
        i[(f / 2 + 2) % dim] = a / 3;
        result[a]            = node(i[0], i[1], i[2]);
      }
    return result;
  }



  Point<dim>
  QuadraticCell::at(const Point<dim> &x) const
  {
    Point<dim> X;
    for (unsigned int n = 0; n < n_nodes; ++n)
      X += polynomial(n % 3, x[0]) * polynomial(n / 3 % 3, x[1]) *
           polynomial(n / 9, x[2]) * nodes[n];
    return X;
  }



  Tensor<2, dim>
  QuadraticCell::gradient(const Point<dim> &x) const
  {
    Tensor<2, dim> result;
    for (unsigned int n = 0; n < n_nodes; ++n)
      {
        const unsigned int i[dim] = {n % 3, n / 3 % 3, n / 9};
        Tensor<1, dim>     slope;
        for (unsigned int d = 0; d < dim; ++d)
          {
            slope[d] = 1.;
            for (unsigned int e = 0; e < dim; ++e)
              slope[d] *=
                d == e ? derivative(i[e], x[e]) : polynomial(i[e], x[e]);
          }
        result += dealii::outer_product(nodes[n], slope);
      }
    return result;
  }



  Point<dim>
  QuadraticCell::inverse(const Point<dim> &X) const
  {
    constexpr unsigned int most_iterations = 50;
    constexpr double       tolerance       = 1e-14;

    unsigned int nearest = 0;
    for (unsigned int n = 1; n < n_nodes; ++n)
      if (X.distance_square(nodes[n]) < X.distance_square(nodes[nearest]))
        nearest = n;
    Point<dim> x = place_of(nearest);
    if (X == nodes[nearest])
      return x;
    for (unsigned int i = 0; i < most_iterations; ++i)
      {
        const Tensor<1, dim> step = invert(gradient(x)) * (X - at(x));
        x += step;
        // What is left is the square of it.
        if (step.norm() < std::sqrt(tolerance))
          return x + invert(gradient(x)) * (X - at(x));
      }
    AssertThrow(false, dealii::ExcInternalError());
    return x;
  }



  Point<dim>
  QuadraticCell::worst_point(double &least) const
  {
    const double sign =
      determinant(gradient(Point<dim>(0.5, 0.5, 0.5))) > 0. ? 1. : -1.;
    std::vector<Point<dim>> points = dealii::QGauss<dim>(3).get_points();
    for (unsigned int n = 0; n < n_nodes; ++n)
      points.push_back(place_of(n));
    Point<dim> worst;
    double     most = 0.;
    least           = std::numeric_limits<double>::max();
    for (const Point<dim> &x : points)
      {
        const double det = sign * determinant(gradient(x));
        most             = std::max(most, std::abs(det));
        if (det < least)
          {
            least = det;
            worst = x;
          }
      }
    least /= most;
    return at(worst);
  }
} // namespace lumbricus
