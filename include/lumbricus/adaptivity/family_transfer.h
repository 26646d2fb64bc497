// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_adaptivity_family_transfer_h
#define lumbricus_adaptivity_family_transfer_h

#include <lumbricus/discretization/cell_state.h>
#include <lumbricus/discretization/mixed_space.h>

#include <deal.II/fe/fe_dgp.h>
#include <deal.II/fe/fe_q.h>

#include <vector>

namespace lumbricus
{
  /** The numbers of a State on a cell, as those on its eight children, and
   * back. */
  class FamilyTransfer
  {
  public:
    /** What CellLayout has on a cell. */
    using Values = std::vector<double>;

    /** For numbers laid out so. */
    explicit FamilyTransfer(const CellLayout &layout);

    /** The same functions on child @p c. */
    Values
    to_child(const unsigned int c, const Values &parent) const;

    /** Displacements at the nodes of the parent, and the projection of
     * pressures. */
    Values
    to_parent(const std::vector<Values> &children) const;

  private:
    const dealii::FE_Q<dim>   displacement{MixedSpace::degree};
    const dealii::FE_DGP<dim> pressure{MixedSpace::degree - 1};

    const unsigned int              size;
    const std::vector<unsigned int> scalars, pressures; // where they begin
  };
} // namespace lumbricus

#endif
