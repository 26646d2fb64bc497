// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_mesh_measures_h
#define lumbricus_geometry_mesh_measures_h

#include <lumbricus/geometry/geometry.h>

#include <deal.II/grid/tria_description.h>

#include <array>
#include <map>
#include <vector>

#include "curved_cell.h"
#include "mesh_faces.h"

namespace lumbricus
{
  /**
   * The sections of the segments of a mesh that was made elsewhere, whose
   * cells have their Region as material id.
   *
   * A segment extends along x as far as its liquid or its cavity does, or, where
   * it has none, all of it. Its sections are the ends of this extent and its middle,
   * or rather the planes of mesh faces that are nearest to them and at most a
   * quarter of the extent away: of the wall layers for the ends, of the liquid
   * for the middle (of the wall, where there is no liquid in the body), or those
   * of edges at a cavity. Where there is no such plane, no mesh faces lie in the
   * section. Curved faces and edges count where their other nodes are in the plane,
   * too. Cavities are where @p boundary_ids, those of faces, say.
   */
  std::vector<SegmentSections>
  mesh_sections(const std::vector<dealii::Point<dim>>    &vertices,
                const std::vector<dealii::CellData<dim>> &cells,
                const std::vector<TissueName>            &tissues,
                const unsigned int                        n_segments,
                const std::vector<CavityWall>            &cavities = {},
                const std::map<FaceKey, dealii::types::boundary_id>
                                              &boundary_ids = {},
                const std::vector<CurvedCell> &curved_cells = {});

  /**
   * Three vertices for Geometry::support_points(), of the wall where there is
   * one: A and B are far apart along x, C is far from the line through both.
   */
  std::array<dealii::Point<dim>, 3>
  mesh_support_points(const std::vector<dealii::Point<dim>>    &vertices,
                      const std::vector<dealii::CellData<dim>> &cells,
                      const std::vector<TissueName>            &tissues);
} // namespace lumbricus

#endif
