// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_shape_cache_h
#define lumbricus_discretization_shape_cache_h

#include <lumbricus/discretization/mixed_space.h>

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/point.h>

#include <vector>

namespace lumbricus
{
  /**
   * What the element integrals need of the mesh, which never moves (total
   * Lagrangian): on every locally owned cell, dN_n/dX_J, weights, and points
   * at the quadrature points, and where the nodes are. About 22 kB a cell.
   */
  class ShapeCache
  {
  public:
    /** Nodes padded to a multiple of the widest vector register. */
    static constexpr unsigned int padded_nodes = 32;

    /** Gradients and weights of a cell. */
    struct Cell
    {
      /** dN_n/dX_J at q: [(3 q + J) * padded_nodes + n] [1/mm]. */
      const double *gradients;
      /** Reference volume per quadrature point [mm^3]. */
      const double *JxW;
    };

    /** For the cells of @p space, which is kept by reference; none before
     * reinit(). */
    explicit ShapeCache(const MixedSpace &space);

    /** Compute anew after MixedSpace::distribute_dofs(). */
    void
    reinit();

    /** Owned cells are numbered from zero in the order of iteration. */
    Cell
    cell(const unsigned int owned_index) const;

    /** Value of pressure mode m at q, the same on all cells: [4 q + m]. */
    const double *
    pressure_modes() const;

    /** Values of the nodes at quadrature point @p q, the same on all cells:
     * [n]. */
    const double *
    node_values(const unsigned int q) const;

    /** Where quadrature point @p q is, X [mm]. */
    const dealii::Point<dim> &
    quadrature_point(const unsigned int owned_index,
                     const unsigned int q) const;

    /** Where node @p n is, X [mm]. */
    const dealii::Point<dim> &
    node(const unsigned int owned_index, const unsigned int n) const;

    /** How many cells this rank owns. */
    unsigned int
    n_owned_cells() const;

  private:
    const MixedSpace &space;

    dealii::AlignedVector<double>   gradients;
    std::vector<double>             JxW;
    std::vector<dealii::Point<dim>> points;
    std::vector<dealii::Point<dim>> nodes;
    std::vector<double>             psi;
    std::vector<double>             N;
  };
} // namespace lumbricus

#endif
