// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_cell_state_h
#define lumbricus_discretization_cell_state_h

#include <lumbricus/discretization/mixed_space.h>

#include <deal.II/base/types.h>

#include <vector>

namespace lumbricus
{
  /**
   * The state on one cell, as numbers that mean the same on any mesh and any
   * number of ranks: u at the 27 nodes, for one component after the other,
   * the four modes of p, and u_ref and u_vol as u. Nodes are in the order of
   * FE_Q(2).
   */
  struct CellState
  {
    /** How many numbers u, u_ref and u_vol are each. */
    static constexpr unsigned int n_displacements = dim * MixedSpace::n_nodes;
    /** Where the modes of p begin, behind u. */
    static constexpr unsigned int pressure_begin = n_displacements;
    /** Where u_ref begins. */
    static constexpr unsigned int rest_begin =
      n_displacements + MixedSpace::n_pressure_modes;
    /** Where u_vol begins. */
    static constexpr unsigned int volume_begin = rest_begin + n_displacements;
    /** How many numbers there are: 247. */
    static constexpr unsigned int size = volume_begin + n_displacements;
  };



  /** Reads and writes the state cell by cell. */
  class CellStateAccess
  {
  public:
    /** For the cells of @p space, which is kept by reference. */
    explicit CellStateAccess(const MixedSpace &space);

    /** Read that of @p cell, an active one of MixedSpace::dof_handler: u and p
     * out of @p relevant_solution (ghosted), the rest out of @p state. */
    void
    read(const dealii::DoFHandler<dim>::active_cell_iterator &cell,
         const Vector                                        &relevant_solution,
         const State                                         &state,
         std::vector<double>                                 &values);

    /** Write @p values to what this rank owns of it in @p state. */
    void
    write(const dealii::DoFHandler<dim>::active_cell_iterator &cell,
          const std::vector<double>                           &values,
          State                                               &state);

  private:
    void
    get_indices(const dealii::DoFHandler<dim>::active_cell_iterator &cell);

    const MixedSpace &space;

    std::vector<dealii::types::global_dof_index> indices;
    std::vector<dealii::types::global_dof_index> rest_indices;
  };
} // namespace lumbricus

#endif
