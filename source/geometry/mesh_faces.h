// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_mesh_faces_h
#define lumbricus_geometry_mesh_faces_h

#include <lumbricus/core/dimension.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/grid/tria_description.h>

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

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

  /** A face as one of its cells has it. */
  struct FaceOfCell
  {
    FaceKey      key;  ///< equal for the cells on both sides
    unsigned int cell; ///< which cell
    unsigned int face; ///< which of its faces, in deal.II's numbering
  };

  /** The faces of all cells; those with the same key stand side by side. */
  inline std::vector<FaceOfCell>
  sorted_faces(const std::vector<dealii::CellData<dim>> &cells)
  {
    std::vector<FaceOfCell> faces;
    faces.reserve(6 * cells.size());
    for (unsigned int c = 0; c < cells.size(); ++c)
      for (unsigned int f = 0; f < 6; ++f)
        faces.push_back({face_key(cells[c], f), c, f});
    std::sort(faces.begin(),
              faces.end(),
              [](const FaceOfCell &a, const FaceOfCell &b) {
                return std::tie(a.key, a.cell, a.face) <
                       std::tie(b.key, b.cell, b.face);
              });
    return faces;
  }
} // namespace lumbricus

#endif
