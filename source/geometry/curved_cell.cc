// SPDX-License-Identifier: LGPL-2.1-or-later
#include "curved_cell.h"

#include <lumbricus/parameters/expression.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>

namespace lumbricus
{
  namespace
  {
    using FaceNodes =
      std::array<dealii::Point<dim>, QuadraticCell::n_face_nodes>;



    std::string
    folded_cells(const std::vector<CurvedCell> &curved_cells)
    {
      // Relative to the largest in the cell.
      constexpr double  least_determinant = 1e-3;
      std::size_t       n                 = 0;
      const CurvedCell *first             = nullptr;
      for (const CurvedCell &cell : curved_cells)
        {
          double least;
          cell.shape.worst_point(least);
          if (least >= least_determinant)
            continue;
          ++n;
          first = first == nullptr ? &cell : first;
        }
      if (n == 0)
        return "";
      double     least;
      const auto X = first->shape.worst_point(least);
      return " has " + std::to_string(n) +
             " curved cells that are folded or flat; the first is element " +
             std::to_string(first->number) + ", at " + point_text(X) +
             ". Mesh that place with smaller cells, or with better shaped ones "
             "('Mesh.HighOrderOptimize = 2;').";
    }



    bool
    are_same(const FaceNodes &a, const FaceNodes &b)
    {
      double size = 0.;
      for (const auto &X : a)
        size = std::max(size, X.distance(a[0]));
      return std::all_of(a.begin(), a.end(), [&](const auto &X) {
        return std::any_of(b.begin(), b.end(), [&](const auto &Y) {
          return X.distance(Y) < 1e-6 * size;
        });
      });
    }



    std::string
    gaps(const std::vector<CurvedCell>            &curved_cells,
         const std::vector<dealii::CellData<dim>> &cells)
    {
      const auto faces = sorted_faces(cells);
      for (std::size_t i = 1; i < faces.size(); ++i)
        if (faces[i].key == faces[i - 1].key)
          {
            const CurvedCell &one   = curved_cells[faces[i - 1].cell];
            const CurvedCell &other = curved_cells[faces[i].cell];
            const FaceNodes   nodes = one.face_nodes(faces[i].key);
            if (!are_same(nodes, other.face_nodes(faces[i].key)))
              return " has the elements " + std::to_string(one.number) + " and " +
                     std::to_string(other.number) +
                     ", whose common face is curved in two ways, at " +
                     point_text(nodes[nodes.size() / 2]) +
                     ": the nodes between its corners have to be the same. Mesh "
                     "all volumes together, with one 'Mesh.ElementOrder'.";
          }
      return "";
    }
  } // namespace



  dealii::Point<dim>
  CurvedCell::node_between(const unsigned int v, const unsigned int w) const
  {
    const auto place = [&](const unsigned int vertex) {
      return std::find(vertices.begin(), vertices.end(), vertex) -
             vertices.begin();
    };
    const unsigned int a = place(v), b = place(w);
    return shape.node((a & 1) + (b & 1),
                      ((a & 2) + (b & 2)) / 2,
                      ((a & 4) + (b & 4)) / 4);
  }



  FaceNodes
  CurvedCell::face_nodes(const FaceKey &key) const
  {
    for (unsigned int f = 0; f < 6; ++f)
      {
        FaceKey own;
        for (unsigned int v = 0; v < own.size(); ++v)
          own[v] =
            vertices[dealii::GeometryInfo<dim>::face_to_cell_vertices(f, v)];
        std::sort(own.begin(), own.end());
        if (own == key)
          return shape.face_nodes(f);
      }
    Assert(false, dealii::ExcInternalError());
    return {};
  }



  std::string
  what_is_wrong(const std::vector<CurvedCell>            &curved_cells,
                const std::vector<dealii::CellData<dim>> &cells)
  {
    if (curved_cells.empty())
      return "";
    const std::string folded = folded_cells(curved_cells);
    return folded.empty() ? gaps(curved_cells, cells) : folded;
  }
} // namespace lumbricus
