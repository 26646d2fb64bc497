// SPDX-License-Identifier: LGPL-2.1-or-later

#include "nearness.h"

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lumbricus
{
  using dealii::Point;
  using dealii::Tensor;

  double
  distance_to_face(const std::array<Point<dim>, 4> &corners,
                   const Point<dim>                &X)
  {
    double u = 0.5, v = 0.5;
    for (unsigned int i = 0; i < 20; ++i)
      {
        const Tensor<1, dim> along_u =
          (1 - v) * (corners[1] - corners[0]) + v * (corners[3] - corners[2]);
        const Tensor<1, dim> along_v =
          (1 - u) * (corners[2] - corners[0]) + u * (corners[3] - corners[1]);
        const Tensor<1, dim> off =
          X - (corners[0] + v * (corners[2] - corners[0]) + u * along_u);

        // Gauss-Newton: least squares in the tangent plane.
        const double a = along_u * along_u, b = along_u * along_v,
                     c   = along_v * along_v;
        const double det = a * c - b * b;
        if (!(det > 1e-12 * a * c))
          break;
        const double p = along_u * off, q = along_v * off;
        const double du = (c * p - b * q) / det, dv = (a * q - b * p) / det;
        u += du;
        v += dv;
        if (std::abs(u - 0.5) > 5 || std::abs(v - 0.5) > 5)
          break;
        if (std::abs(du) + std::abs(dv) < 1e-10)
          return u < 0 || u > 1 || v < 0 || v > 1 ?
                   std::numeric_limits<double>::infinity() :
                   off.norm();
      }
    return std::numeric_limits<double>::infinity();
  }



  double
  distance_to_edge(const Point<dim> &A,
                   const Point<dim> &B,
                   const Point<dim> &X)
  {
    const Tensor<1, dim> AB = B - A;
    const double t = std::min(1., std::max(0., (X - A) * AB / (AB * AB)));
    return X.distance(A + t * AB);
  }



  std::pair<Point<dim>, double>
  nearest_of_edges(const Point<dim> &A,
                   const Point<dim> &B,
                   const Point<dim> &C,
                   const Point<dim> &D)
  {
    const Tensor<1, dim> p = B - A, q = D - C, r = C - A;
    const double         pp = p * p, pq = p * q, qq = q * q;
    const double         det = pp * qq - pq * pq;
    if (det > 1e-12 * pp * qq)
      {
        const double s = (qq * (p * r) - pq * (q * r)) / det;
        const double t = (pq * (p * r) - pp * (q * r)) / det;
        if (s > 0 && s < 1 && t > 0 && t < 1)
          {
            const Point<dim> X = A + s * p;
            return {X, X.distance(C + t * q)};
          }
      }
    return {A, std::numeric_limits<double>::infinity()};
  }



  bool
  is_inside(const std::array<Point<dim>, 8> &corners,
            const Point<dim>                &X,
            const double                     margin)
  {
    Tensor<1, dim> xi({0.5, 0.5, 0.5});
    for (unsigned int i = 0; i < 30; ++i)
      {
        Tensor<1, dim> off = X;
        Tensor<2, dim> J;
        for (unsigned int v = 0; v < 8; ++v)
          {
            std::array<double, dim> w, dw;
            for (unsigned int d = 0; d < dim; ++d)
              {
                const bool upper = (v & (1u << d)) != 0;
                w[d]             = upper ? xi[d] : 1 - xi[d];
                dw[d]            = upper ? 1 : -1;
              }
            const Tensor<1, dim> corner = corners[v];
            off -= w[0] * w[1] * w[2] * corner;
            for (unsigned int j = 0; j < dim; ++j)
              {
                J[j][0] += dw[0] * w[1] * w[2] * corner[j];
                J[j][1] += w[0] * dw[1] * w[2] * corner[j];
                J[j][2] += w[0] * w[1] * dw[2] * corner[j];
              }
          }
        if (determinant(J) == 0.)
          return false;
        const Tensor<1, dim> step = dealii::invert(J) * off;
        xi += step;
        for (unsigned int d = 0; d < dim; ++d)
          if (std::abs(xi[d] - 0.5) > 2)
            return false;
        if (step.norm() < 1e-10)
          {
            for (unsigned int d = 0; d < dim; ++d)
              if (xi[d] < margin || xi[d] > 1 - margin)
                return false;
            return true;
          }
      }
    return false;
  }
} // namespace lumbricus
