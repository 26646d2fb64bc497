// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_element_kernel_h
#define lumbricus_discretization_element_kernel_h

#include <lumbricus/anatomy/tissue.h>
#include <lumbricus/discretization/cell_linearisation.h>

#include <deal.II/base/types.h>

#include <array>
#include <vector>

namespace lumbricus
{
  /**
   * The integrals over one cell, by nodes and pressure modes:
   *
   *   force[i][n] = int P_iJ dN_n/dX_J dV,
   *   volume[m]   = int psi_m c dV,
   *
   * and their linearisation.
   */
  class ElementKernel
  {
  public:
    /** Nodes of a cell. */
    static constexpr unsigned int n_nodes = MixedSpace::n_nodes;
    /** Pressures of a cell. */
    static constexpr unsigned int n_modes = MixedSpace::n_pressure_modes;
    /** Quadrature points of a cell. */
    static constexpr unsigned int n_q = MixedSpace::n_q_points;
    /** Nodes with padding. */
    static constexpr unsigned int padded = ShapeCache::padded_nodes;

    /** Unknowns of the cell: set before evaluate(). Padding stays zero. */
    double u[dim][padded] = {};
    /** Pressure modes [N/mm^2]: set before evaluate(). */
    double p[n_modes] = {};

    /** Deformation gradients at the quadrature points, for outputs too. */
    std::array<dealii::Tensor<2, dim>, n_q> F;

    /** Nodal forces [N], by evaluate(): [i][n]. Padding is zero. */
    double force[dim][padded];
    /** Violated volume constraint by pressure mode [mm^3], by evaluate(). */
    double volume[n_modes];

    /** Read u and p of @p cell, and its indices, from a ghosted vector. */
    void
    read(const MixedSpace                                    &space,
         const dealii::DoFHandler<dim>::active_cell_iterator &cell,
         const Vector                                        &relevant_solution,
         std::vector<dealii::types::global_dof_index>        &indices);

    /** Read u of @p cell from the vector of a NodalHistory, with @p indices, which
     * are as many as MixedSpace::rest_fe has on a cell. */
    void
    read_history(const MixedSpace                                    &space,
                 const dealii::DoFHandler<dim>::active_cell_iterator &cell,
                 const Vector                                        &history,
                 std::vector<dealii::types::global_dof_index>        &indices);

    /** Set u and p from values in the order of CellUnknowns. */
    void
    set(const double *values);

    /** Write force and volume in the order of CellUnknowns. */
    void
    get_residual(double *values) const;

    /** Compute F from u; @return the smallest determinant of F. */
    double
    compute_deformation(const ShapeCache::Cell &cell);

    /** u where the nodes have the values @p N, [n]. */
    dealii::Tensor<1, dim>
    displacement(const double *N) const;

    /** The value of p at quadrature point @p q. */
    double
    pressure(const double *pressure_modes, const unsigned int q) const;

    /**
     * Compute the integrals, and the linearisation where there is one.
     * @param points one per quadrature point, of @p tissue.
     * @return the smallest determinant of F; where that is not positive,
     * nothing else is computed.
     */
    double
    evaluate(const ShapeCache::Cell &cell,
             const double           *pressure_modes,
             const Tissue           &tissue,
             const MaterialPoint    *points,
             CellLinearisation      *linearisation);

  private:
    void
    add_residual(const ShapeCache::Cell &cell,
                 const double           *pressure_modes,
                 const unsigned int      q,
                 const MaterialResponse &response);
  };
} // namespace lumbricus

#endif
