// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_equilibrium_cell_laplacian_h
#define lumbricus_equilibrium_cell_laplacian_h

#include <lumbricus/discretization/shape_cache.h>

namespace lumbricus
{
  /**
   * The Laplacian of the three components of the displacement on a cell at rest,
   *
   *   K_mn = int Grad N_m . Grad N_n dV.
   */
  class CellLaplacian
  {
  public:
    /** That of @p cell. */
    explicit CellLaplacian(const ShapeCache::Cell &cell);

    /** Set @p y to K @p x, both in the order of CellUnknowns; the modes of the
     * pressure in y are 0. */
    void
    vmult(const double *x, double *y) const;

    /** K_nn. */
    double
    diagonal(const unsigned int n) const
    {
      return K[n][n];
    }

  private:
    static constexpr unsigned int n_nodes = MixedSpace::n_nodes;
    static constexpr unsigned int padded  = ShapeCache::padded_nodes;

    /** By rows, padded with zeros. */
    alignas(64) double K[n_nodes][padded] = {};
  };
} // namespace lumbricus

#endif
