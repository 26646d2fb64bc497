// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/cell_sizes.h>
#include <lumbricus/discretization/rounding_level.h>

#include <cmath>
#include <limits>

namespace lumbricus
{
  namespace
  {
    using cell_sizes::n_q;
  } // namespace



  void
  RoundingLevel::reinit(const ShapeCache &shapes)
  {
    norms.clear();
    norms.reserve(shapes.n_owned_cells());
    for (unsigned int i = 0; i < shapes.n_owned_cells(); ++i)
      {
        const ShapeCache::Cell cell = shapes.cell(i);
        CellNorms              squares{0., 0., 0.};
        for (unsigned int q = 0; q < n_q; ++q)
          {
            constexpr unsigned int n = dim * ShapeCache::padded_nodes;
            const double          *g = cell.gradients + q * n;
            double                 gradient_square = 0.;
            for (unsigned int k = 0; k < n; ++k)
              gradient_square += g[k] * g[k];
            const double w_square = cell.JxW[q] * cell.JxW[q];
            squares.gradient += gradient_square / n_q;
            squares.force += w_square * gradient_square;
            squares.volume += w_square;
          }
        norms.push_back({std::sqrt(squares.gradient),
                         std::sqrt(squares.force),
                         std::sqrt(squares.volume)});
      }
  }



  void
  RoundingLevel::clear()
  {
    sum_force_square = 0.;
    sum_volume       = 0.;
  }



  void
  RoundingLevel::add(const unsigned int   i,
                     const ElementKernel &kernel,
                     const double        *pressure_modes,
                     const double         mu,
                     const MaterialPoint *points)
  {
    constexpr double eps           = std::numeric_limits<double>::epsilon();
    constexpr double n_of_response = 4.;
    // What varies little within a cell is taken in its middle.
    constexpr unsigned int middle = n_q / 2;

    double u_square = 0.;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
        u_square += kernel.u[c][n] * kernel.u[c][n];
    const double u = std::sqrt(u_square / MixedSpace::n_nodes);

    const double F   = kernel.F[middle].norm();
    const double p   = kernel.pressure(pressure_modes, middle);
    const double S   = mu * points[middle].reference.G_inverse.norm_square() +
                     std::abs(p) * F;
    const double e_F = eps * (n_of_response * F + norms[i].gradient * u);
    const double e_f = S * e_F * norms[i].force;
    sum_force_square += e_f * e_f;
    sum_volume += F * F * e_F * norms[i].volume;
  }



  double
  RoundingLevel::force_square() const
  {
    return sum_force_square;
  }



  double
  RoundingLevel::volume() const
  {
    return sum_volume;
  }
} // namespace lumbricus
