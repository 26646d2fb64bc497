// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_element_kernel_h
#define lumbricus_discretization_element_kernel_h

#include <lumbricus/discretization/shape_cache.h>
#include <lumbricus/materials/material_law.h>

#include <array>
#include <vector>

namespace lumbricus
{
  /**
   * The integrals over one cell, in nodal blocks:
   *
   *   force[i][n]        = int P_iJ dN_n/dX_J dV,
   *   volume[m]          = int psi_m c dV,
   *   K_uu(i,k)[n][m]    = int dN_n/dX_J A_iJkL dN_m/dX_L dV,
   *   K_up[i][n][m]      = int dN_n/dX_J Q_iJ psi_m dV,
   *   K_pp[n][m]         = int psi_n dc/dp psi_m dV.
   */
  class ElementKernel
  {
  public:
    static constexpr unsigned int n_nodes = MixedSpace::n_nodes;
    static constexpr unsigned int n_modes = MixedSpace::n_pressure_modes;
    static constexpr unsigned int n_q     = MixedSpace::n_q_points;
    static constexpr unsigned int padded  = ShapeCache::padded_nodes;

    /** Unknowns of the cell: set before evaluate(). Padding stays zero. */
    double u[dim][padded] = {};
    double p[n_modes]     = {};

    /** Deformation gradients at the quadrature points, for outputs too. */
    std::array<dealii::Tensor<2, dim>, n_q> F;

    double force[dim][padded];
    double volume[n_modes];
    double K_up[dim][n_nodes][n_modes];
    double K_pp[n_modes][n_modes];

    /** K_uu for components i and k at nodes n and m. */
    double
    K_uu(const unsigned int i,
         const unsigned int k,
         const unsigned int n,
         const unsigned int m) const
    {
      return i <= k ? K_blocks[n][block(i, k) * padded + m] :
                      K_blocks[m][block(k, i) * padded + n];
    }

    /** Read u and p of @p cell, and its indices, from a ghosted vector. */
    void
    read(const MixedSpace                                    &space,
         const dealii::DoFHandler<dim>::active_cell_iterator &cell,
         const Vector                                        &relevant_solution,
         std::vector<dealii::types::global_dof_index>        &indices);

    /** Compute F from u; @return the smallest determinant of F. */
    double
    compute_deformation(const ShapeCache::Cell &cell);

    /** Component @p c of u at quadrature point @p q. */
    double
    displacement(const double      *node_values,
                 const unsigned int q,
                 const unsigned int c) const;

    /** The value of p at quadrature point @p q. */
    double
    pressure(const double *pressure_modes, const unsigned int q) const;

    /**
     * Compute the integrals, of the tangent too where @p with_tangent.
     * @param references one ReferencePoint per quadrature point.
     * @return the smallest determinant of F; where that is not positive,
     * nothing else is computed.
     */
    double
    evaluate(const ShapeCache::Cell &cell,
             const double           *pressure_modes,
             const MaterialLaw      &law,
             const ReferencePoint   *references,
             const bool              with_tangent);

  private:
    static constexpr unsigned int n_blocks = 6;

    static constexpr unsigned int
    block(const unsigned int i, const unsigned int k)
    {
      return i == 0 ? k : i + k + 1; // 00 01 02 11 12 22 -> 0 ... 5
    }

    void
    add_residual(const ShapeCache::Cell &cell,
                 const double           *pressure_modes,
                 const unsigned int      q,
                 const MaterialResponse &response);

    void
    add_tangent(const ShapeCache::Cell &cell,
                const double           *pressure_modes,
                const unsigned int      q,
                const MaterialResponse &response);

    alignas(64) double H[n_q * dim][n_blocks * padded];
    alignas(64) double K_blocks[padded][n_blocks * padded];
  };
} // namespace lumbricus

#endif
