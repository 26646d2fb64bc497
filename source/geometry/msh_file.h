// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_msh_file_h
#define lumbricus_geometry_msh_file_h

#include <deal.II/base/point.h>
#include <deal.II/grid/tria_description.h>

#include <map>
#include <string>
#include <vector>

#include "mesh_faces.h"

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

    /** What is no quadrilateral of four nodes, in a physical surface. */
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
   * Read a text file of Gmsh, format 2.x or 4.1, with hexahedra of eight
   * nodes. Throws ExcInput naming @p parameter, the file and, where there is
   * one, the line.
   */
  MshFile
  read_msh_file(const std::string &parameter, const std::string &file_name);
} // namespace lumbricus

#endif
