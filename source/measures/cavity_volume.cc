// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/area_derivative.h>
#include <lumbricus/measures/cavity_volume.h>

namespace lumbricus
{
  namespace
  {
    // Between pistons v = D x with this diagonal D.
    constexpr double across[dim] = {0., 0.5, 0.5};



    dealii::Tensor<1, dim>
    field(const SurfaceKernel &surface, const CavityWall &wall)
    {
      dealii::Tensor<1, dim> v = surface.X + surface.u - wall.origin;
      for (unsigned int c = 0; c < dim; ++c)
        v[c] *= wall.pistons.empty() ? 1. / dim : across[c];
      return v;
    }



    // F^(-T) Grad N of all nodes.
    void
    set_spatial_gradients(
      const SurfaceKernel &surface,
      dealii::Tensor<1, dim> (&gradients)[SurfaceKernel::n_nodes])
    {
      const auto   cofactor = dealii::cofactor(surface.F);
      const double J        = dealii::determinant(surface.F);
      for (unsigned int n = 0; n < SurfaceKernel::n_nodes; ++n)
        gradients[n] = cofactor * surface.gradients[n] / J;
    }
  } // namespace



  dealii::Tensor<1, dim>
  area_out_of_cavity(const SurfaceKernel &surface)
  {
    return -surface.JxW * (dealii::cofactor(surface.F) * surface.N);
  }



  double
  volume_in_cavity(const SurfaceKernel &surface, const CavityWall &wall)
  {
    return field(surface, wall) * area_out_of_cavity(surface);
  }



  void
  add_volume_derivative(const SurfaceKernel &surface,
                        const CavityWall    &wall,
                        double              *of_cell)
  {
    const auto a = area_out_of_cavity(surface);
    if (wall.pistons.empty())
      {
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int n = 0; n < SurfaceKernel::n_nodes; ++n)
            of_cell[CellUnknowns::displacement(c, n)] +=
              surface.values[n] * a[c];
        return;
      }

    // d(n da) = (g . du) n da - g (du . n da), where du = N_n du_n, g its
    // gradient.
    const auto             v = field(surface, wall);
    dealii::Tensor<1, dim> g[SurfaceKernel::n_nodes];
    set_spatial_gradients(surface, g);
    for (unsigned int n = 0; n < SurfaceKernel::n_nodes; ++n)
      for (unsigned int c = 0; c < dim; ++c)
        of_cell[CellUnknowns::displacement(c, n)] +=
          (across[c] * surface.values[n] - v * g[n]) * a[c] +
          (v * a) * g[n][c];
  }



  void
  add_volume_second_derivative(const SurfaceKernel &surface,
                               const CavityWall    &wall,
                               const double         factor,
                               std::vector<double> &matrix)
  {
    if (wall.pistons.empty())
      {
        // It takes n out of the wall.
        add_area_derivative(surface, -factor, matrix);
        return;
      }

    const auto             a = area_out_of_cavity(surface);
    const auto             v = field(surface, wall);
    dealii::Tensor<1, dim> g[SurfaceKernel::n_nodes];
    set_spatial_gradients(surface, g);
    for (unsigned int n = 0; n < SurfaceKernel::n_nodes; ++n)
      for (unsigned int m = 0; m < SurfaceKernel::n_nodes; ++m)
        {
          // The area is quadratic in F: its second derivative with respect to
          // du_n and du_m is their vector product times this.
          const double turn =
            -surface.JxW * surface.N *
            dealii::cross_product_3d(surface.gradients[n],
                                     surface.gradients[m]);
          const double N_n = surface.values[n], N_m = surface.values[m];
          for (unsigned int c = 0; c < dim; ++c)
            {
              double *row =
                &matrix[CellUnknowns::displacement(c, n) *
                        CellUnknowns::n_per_cell];
              for (unsigned int k = 0; k < dim; ++k)
                {
                  double second =
                    N_n * across[c] * (a[c] * g[m][k] - a[k] * g[m][c]) +
                    N_m * across[k] * (a[k] * g[n][c] - a[c] * g[n][k]);
                  if (c != k)
                    {
                      // e_c x e_k = +-e_l.
                      const double sign = (c + 1) % dim == k ? 1. : -1.;
                      second += sign * turn * v[dim - c - k];
                    }
                  row[CellUnknowns::displacement(k, m)] += factor * second;
                }
            }
        }
  }
} // namespace lumbricus
