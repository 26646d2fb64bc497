// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_cell_state_h
#define lumbricus_discretization_cell_state_h

#include <lumbricus/core/nodal_history.h>
#include <lumbricus/discretization/mixed_space.h>

#include <deal.II/base/types.h>

#include <vector>

namespace lumbricus
{
  /**
   * Where on a cell the numbers of a State are, which mean the same on any mesh
   * and any number of ranks: u at the 27 nodes, for one component after the
   * other, and the four modes of p; every history as u, by name; every earlier
   * solution as u and p. Nodes are in the order of FE_Q(2).
   */
  class CellLayout
  {
  public:
    /** How many numbers a displacement is. */
    static constexpr unsigned int n_displacements = dim * MixedSpace::n_nodes;
    /** Where the modes of p begin, behind u. */
    static constexpr unsigned int pressure_begin = n_displacements;
    /** How many numbers a solution is. */
    static constexpr unsigned int n_solution =
      n_displacements + MixedSpace::n_pressure_modes;

    /** How many numbers there are, for so many histories and earlier
     * solutions: 247 with u_ref, u_vol and none. */
    static constexpr unsigned int
    size_of(const unsigned int n_histories, const unsigned int n_past)
    {
      return n_solution * (1 + n_past) + n_displacements * n_histories;
    }

    /** Of the histories and the past that @p state has. */
    explicit CellLayout(const State &state);

    /** How many numbers there are. */
    unsigned int
    size() const;

    /** Where a history begins. */
    unsigned int
    begin_of(const NodalHistory &history) const;

    /** Where each displacement begins: of the solution, of histories, of
     * earlier solutions. */
    const std::vector<unsigned int> &
    displacement_begins() const;

    /** Where the modes of each pressure begin. */
    const std::vector<unsigned int> &
    pressure_begins() const;

  private:
    std::vector<std::string>  names; ///< of the histories
    std::vector<unsigned int> displacements, pressures;
  };



  /** Reads a state cell by cell. */
  class CellStateReader
  {
  public:
    /** Both arguments are kept by reference. Collective. */
    CellStateReader(const MixedSpace &space, const State &state);

    /** Read that of @p cell, an active one of MixedSpace::dof_handler. */
    void
    read(const dealii::DoFHandler<dim>::active_cell_iterator &cell,
         std::vector<double>                                 &values);

    const CellLayout layout; ///< of what is read

  private:
    const MixedSpace &space;
    const State      &state;

    std::vector<Vector> relevant; ///< the solution, and earlier ones
    std::vector<dealii::types::global_dof_index> indices;
    std::vector<dealii::types::global_dof_index> rest_indices;
  };



  /** Writes a state cell by cell. */
  class CellStateWriter
  {
  public:
    /** Both arguments are kept by reference. The state has to be compressed
     * after all has been written. */
    CellStateWriter(const MixedSpace &space, State &state);

    /** Write @p values to what this rank owns of @p cell. */
    void
    write(const dealii::DoFHandler<dim>::active_cell_iterator &cell,
          const std::vector<double>                           &values);

    const CellLayout layout; ///< of what is written

  private:
    const MixedSpace &space;
    State            &state;

    std::vector<dealii::types::global_dof_index> indices;
    std::vector<dealii::types::global_dof_index> rest_indices;
  };
} // namespace lumbricus

#endif
