// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_surface_kernel_h
#define lumbricus_discretization_surface_kernel_h

#include <lumbricus/discretization/shape_cache.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/base/tensor.h>
#include <deal.II/fe/fe_values.h>

#include <array>

namespace lumbricus
{
  /**
   * A quadrature point on the face of a cell, as integrals over surfaces see
   * it: the nodes of the cell, and with their displacements u_n
   *
   *   u = sum_n N_n u_n,   F = I + sum_n u_n x Grad N_n.
   */
  class SurfaceKernel
  {
  public:
    /** Nodes of a cell. */
    static constexpr unsigned int n_nodes = MixedSpace::n_nodes;

    /** For the cells of @p space, which is kept by reference, at the points of
     * @p quadrature. */
    SurfaceKernel(const MixedSpace                  &space,
                  const dealii::Quadrature<dim - 1> &quadrature);

    /** At those of MixedSpace::face_quadrature. */
    explicit SurfaceKernel(const MixedSpace &space);

    /** Go to face @p face of @p cell. */
    void
    reinit(const dealii::DoFHandler<dim>::active_cell_iterator &cell,
           const unsigned int                                   face);

    /** How many quadrature points a face has. */
    unsigned int
    n_points() const;

    /** Set all that follows, at quadrature point @p q, where the nodes have the
     * displacements @p node_displacements, [i][n]. */
    void
    set(const unsigned int q,
        const double (&node_displacements)[dim][ShapeCache::padded_nodes]);

    /** The value of p at the point, from those of @p modes. */
    double
    pressure(const double (&modes)[MixedSpace::n_pressure_modes]) const;

    /** The nodes on the face: all others have N_n = 0 and no derivatives along the
     * face. By reinit(). */
    std::array<unsigned int, 9> face_nodes;

    double                 JxW;                ///< area at rest [mm^2]
    double                 values[n_nodes];    ///< N_n
    dealii::Tensor<1, dim> gradients[n_nodes]; ///< dN_n/dX [1/mm]
    dealii::Point<dim>     X;                  ///< at rest [mm]
    dealii::Tensor<1, dim> N;                  ///< outward normal at rest
    dealii::Tensor<1, dim> u;                  ///< [mm]
    dealii::Tensor<2, dim> F;                  ///< [i][J]

  private:
    const MixedSpace         &space;
    dealii::FEFaceValues<dim> face_values;
    unsigned int              point = 0;
  };
} // namespace lumbricus

#endif
