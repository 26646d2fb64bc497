// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_checkpoint_mesh_record_h
#define lumbricus_checkpoint_mesh_record_h

#include <lumbricus/adaptivity/mesh_refinement.h>

#include <deal.II/grid/cell_id.h>

#include <set>

namespace lumbricus
{
  /** A cell of a mesh, the same whatever the partition. */
  using CellKey = dealii::CellId::binary_type;

  /** All cells of the mesh that are refined, on all ranks: an eighth as many
   * as there are active cells. Collective. */
  std::set<CellKey>
  refined_cells(const ParallelMesh &triangulation);

  /** Refine the coarse mesh until these cells are refined. Collective. */
  void
  refine_cells(ParallelMesh &triangulation, const std::set<CellKey> &refined);
} // namespace lumbricus

#endif
