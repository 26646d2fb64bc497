// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_mesh_checks_h
#define lumbricus_geometry_mesh_checks_h

#include <lumbricus/core/dimension.h>

#include <deal.II/base/point.h>
#include <deal.II/grid/tria_description.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * What is wrong with a mesh that was made elsewhere, and what to do about
   * it, as the end of a sentence about its file; empty if it can be used.
   *
   * Looks for cells that are folded (turned ones have to be turned back
   * before) or there twice, faces of more than two cells, vertices at the same
   * place, touching_parts(), and parts that share no faces.
   */
  std::string
  what_is_wrong(const std::vector<dealii::Point<dim>>    &vertices,
                const std::vector<dealii::CellData<dim>> &cells);
} // namespace lumbricus

#endif
