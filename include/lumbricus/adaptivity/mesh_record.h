// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_adaptivity_mesh_record_h
#define lumbricus_adaptivity_mesh_record_h

#include <lumbricus/adaptivity/mark_where.h>
#include <lumbricus/discretization/cell_key.h>

#include <set>

namespace lumbricus
{
  /** All cells of the mesh that are refined, on all ranks: an eighth as many
   * as there are active cells. Collective. */
  std::set<CellKey>
  refined_cells(const ParallelMesh &triangulation);

  /** Refine the coarse mesh until these cells are refined. Collective. */
  void
  refine_cells(ParallelMesh &triangulation, const std::set<CellKey> &refined);

  /** Coarsen until the coarse mesh is left. Collective. */
  void
  coarsen_completely(ParallelMesh &triangulation);
} // namespace lumbricus

#endif
