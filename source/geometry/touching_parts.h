// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_touching_parts_h
#define lumbricus_geometry_touching_parts_h

#include <lumbricus/core/dimension.h>

#include <deal.II/base/point.h>
#include <deal.II/grid/tria_description.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * Where parts of a mesh touch or overlap without sharing their faces, as at a
   * change of mesh size with hanging nodes, so that they would come apart; and
   * what to do about it, as the end of a sentence about its file. Empty if
   * there is no such place.
   *
   * Looks, on the boundary of the cells, for
   *
   * - vertices on faces and edges they are none of,
   * - edges that cross,
   * - vertices inside of cells,
   * - two or three edges that bridge one, as where a curved surface has hanging
   *   nodes, which then are not on the flat face beside.
   *
   * Two things touch that are nearer to each other than a thousandth of the
   * shortest edge of the cells there. A slit that is wider is left alone.
   */
  std::string
  touching_parts(const std::vector<dealii::Point<dim>>    &vertices,
                 const std::vector<dealii::CellData<dim>> &cells);

  /** How to make parts share their faces, for messages. */
  extern const std::string how_to_join;
} // namespace lumbricus

#endif
