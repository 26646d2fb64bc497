// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_mesh_faces_h
#define lumbricus_geometry_mesh_faces_h

#include <lumbricus/core/dimension.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/grid/tria_description.h>

#include <algorithm>
#include <array>

namespace lumbricus
{
  /** A quadrilateral by the numbers of its vertices, in rising order. */
  using FaceKey = std::array<unsigned int, 4>;

  /** Face @p f of a hexahedron, in deal.II's numbering. */
  inline FaceKey
  face_key(const dealii::CellData<dim> &cell, const unsigned int f)
  {
    FaceKey key;
    for (unsigned int v = 0; v < key.size(); ++v)
      key[v] =
        cell.vertices[dealii::GeometryInfo<dim>::face_to_cell_vertices(f, v)];
    std::sort(key.begin(), key.end());
    return key;
  }
} // namespace lumbricus

#endif
