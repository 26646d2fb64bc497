// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_msh_file_h
#define lumbricus_geometry_msh_file_h

#include <deal.II/base/point.h>
#include <deal.II/grid/tria_description.h>

#include <map>
#include <string>
#include <vector>

#include "mesh_faces.h"
#include "quadratic_cell.h"

namespace lumbricus
{
  /**
   * What a Gmsh file says. The tag of a physical group is a number > 0; what
   * belongs to none has the tag 0.
   */
  struct MshFile
  {
    /** A quadrilateral and the physical surface it is in. */
    struct Face
    {
      /** By their numbers in MshFile::vertices. */
      FaceKey vertices;
      /** The tag of the physical surface. */
      unsigned int tag;
    };

    /** What is no face of the file's hexahedra, in a physical surface. */
    struct OtherFace
    {
      /** Three of its corners, by their numbers in MshFile::vertices. */
      std::array<unsigned int, 3> corners;
      /** The tag of the physical surface. */
      unsigned int tag;
      /** What it is, in the plural. */
      std::string kind;
    };

    /** The vertices of hexahedra only. */
    std::vector<dealii::Point<dim>> vertices;
    /** Hexahedra in deal.II's numbering; the material id is the tag. */
    std::vector<dealii::CellData<dim>> cells;
    /** The number of each in the file. */
    std::vector<std::size_t> numbers;
    /** The shape of each where the file is of second order; else empty. Its
     * corners are as in cells. */
    std::vector<QuadraticCell> shapes;
    /** Whether these have nodes of their own on faces, of which each has nine
     * then, and eight otherwise. */
    bool complete = false;
    /** Quadrilaterals that are in a physical surface. */
    std::vector<Face> faces;
    /** Other elements that are in a physical surface; a vertex that is none of
     * a hexahedron has the number dealii::numbers::invalid_unsigned_int. */
    std::vector<OtherFace> other_faces;

    /** From a tag to its name. */
    std::map<unsigned int, std::string> volume_names;
    /** From a tag of a surface to its name. */
    std::map<unsigned int, std::string> surface_names;
  };



  /**
   * Read a text file of Gmsh, format 2.x or 4.1, with hexahedra of eight, 20 or
   * 27 nodes, of one kind. Throws ExcInput naming @p parameter, the file and, where there is
   * one, the line.
   */
  MshFile
  read_msh_file(const std::string &parameter, const std::string &file_name);
} // namespace lumbricus

#endif
