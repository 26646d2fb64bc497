// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_viscous_memory_h
#define lumbricus_discretization_viscous_memory_h

#include <lumbricus/core/state.h>
#include <lumbricus/discretization/body.h>

#include <deal.II/base/types.h>

#include <set>
#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * What a state remembers of the viscous branches of tissues. Of each there is
   *
   *   ln b = N_n (ln b)_n
   *
   * at the nodes n of a cell, six numbers in the two histories of
   * NodalHistory::of_branch(): the three on the diagonal, and 23, 31, 12. There are
   * as many nodes as quadrature points, so that these have what was remembered of
   * them, and wherever else a new mesh asks b is positive definite.
   */
  class ViscousMemory
  {
  public:
    /** In a step that began where @p state has ended its last one, and that ends at
     * the time @p t. Both are kept by reference. */
    ViscousMemory(const Body &body, const State &state, const double t);

    /** Set MaterialPoint::viscous at the quadrature points of a cell, @p points
     * the first of them. */
    void
    read(const OwnedCell &cell, MaterialPoint *points);

  private:
    const Body  &body;
    const State &state;
    const double since;
    std::vector<dealii::types::global_dof_index> indices;
  };

  /** The histories that a run has because of viscous branches, besides that of the
   * displacement before. */
  std::set<std::string>
  histories_of_branches(const Anatomy &anatomy);

  /** A load step is complete: remember b of all branches. Before
   * remember_displacement(). */
  void
  remember_branches(const Body &body, State &state);
} // namespace lumbricus

#endif
