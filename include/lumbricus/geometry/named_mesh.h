// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_named_mesh_h
#define lumbricus_geometry_named_mesh_h

#include <lumbricus/geometry/geometry.h>
#include <lumbricus/geometry/mesh_faces.h>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace lumbricus
{
  /** What the user says about a mesh file. */
  struct NamedMeshChoices
  {
    std::string              file_name;
    std::vector<std::string> liquids        = {"liquid"};
    std::vector<std::string> wall_layers    = {"wall"};
    std::vector<std::string> round_surfaces = {};
    double                   scale          = 1.;

    bool
    operator==(const NamedMeshChoices &other) const;
  };



  /**
   * The mesh in a file of Gmsh with the meaning its physical names give it.
   *
   * A physical volume is named "<tissue>" or "<tissue> <segment>", a physical
   * surface by its boundary, or "symmetry x", "symmetry y", "symmetry z". The
   * rest of the boundary is called "free".
   */
  struct NamedMesh
  {
    std::vector<dealii::Point<dim>> vertices;
    /** With the material id of their Region. */
    std::vector<dealii::CellData<dim>> cells;

    std::vector<TissueName>    tissues;
    std::vector<std::string>   boundary_names;
    std::vector<SymmetryPlane> symmetry_planes;

    /** Of all faces at the boundary. */
    std::map<FaceKey, dealii::types::boundary_id> boundary_ids;
    std::set<FaceKey>                             round_faces;

    std::vector<SegmentSections>      sections;
    std::array<dealii::Point<dim>, 3> support_points;
    double                            characteristic_length;
  };



  /**
   * Read and check a mesh. Throws ExcInput; @p section is where the choices
   * are parameters, for messages.
   */
  NamedMesh
  read_named_mesh(const std::string &section, const NamedMeshChoices &choices);
} // namespace lumbricus

#endif
