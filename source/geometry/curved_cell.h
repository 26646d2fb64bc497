// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_curved_cell_h
#define lumbricus_geometry_curved_cell_h

#include <deal.II/grid/tria_description.h>

#include <array>
#include <string>
#include <vector>

#include "mesh_faces.h"
#include "quadratic_cell.h"

namespace lumbricus
{
  /** A cell of a mesh file of second order: its shape, and how its corners are
   * called. The cell of the mesh may have these in another order. */
  struct CurvedCell
  {
    /** In the order of QuadraticCell::corner(). */
    std::array<unsigned int, 8> vertices;
    /** Its shape. */
    QuadraticCell shape;
    /** Its number in the file. */
    std::size_t number;

    /** Its node between two of its vertices. */
    dealii::Point<dim>
    node_between(const unsigned int v, const unsigned int w) const;

    /** The nodes of its face between these vertices. */
    std::array<dealii::Point<dim>, QuadraticCell::n_face_nodes>
    face_nodes(const FaceKey &key) const;
  };

  /**
   * What is wrong with curved cells, and what to do about it, as the end of a sentence
   * about their file; empty if they can be used. Looks for folded ones, and for
   * faces whose two sides have other nodes. @p cells are those of the mesh.
   */
  std::string
  what_is_wrong(const std::vector<CurvedCell>            &curved_cells,
                const std::vector<dealii::CellData<dim>> &cells);
} // namespace lumbricus

#endif
