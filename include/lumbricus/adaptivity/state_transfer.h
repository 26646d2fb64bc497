// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_adaptivity_state_transfer_h
#define lumbricus_adaptivity_state_transfer_h

#include <lumbricus/adaptivity/mark_where.h>
#include <lumbricus/discretization/mixed_space.h>

#include <functional>

namespace lumbricus
{
  /**
   * Refine and coarsen the cells that are marked, and take @p state along.
   * On a cell that is refined solutions and histories stay the functions they
   * are. On one that is made of eight, displacements are those at its nodes,
   * pressures are the projection, and what does not fit at hanging nodes gives
   * way.
   * @p renumber is called in between, to number the unknowns of @p space anew.
   * Collective.
   */
  void
  change_mesh(ParallelMesh                &triangulation,
              const MixedSpace            &space,
              const std::function<void()> &renumber,
              State                       &state);

  /** Let what @p state has at hanging nodes of @p space give way to what the other
   * nodes say. Collective. */
  void
  make_conforming(const MixedSpace &space, State &state);
} // namespace lumbricus

#endif
