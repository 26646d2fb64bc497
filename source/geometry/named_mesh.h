// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_named_mesh_h
#define lumbricus_geometry_named_mesh_h

#include <lumbricus/geometry/geometry.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "curved_cell.h"
#include "mesh_faces.h"

namespace lumbricus
{
  /** What the user says about a mesh file. */
  struct NamedMeshChoices
  {
    /** From the working directory. */
    std::string file_name;
    /** The names of the tissues that are liquid. */
    std::vector<std::string> liquids = {"liquid"};
    /** See TissueName::wall_layer. */
    std::vector<std::string> wall_layers = {"wall"};
    /** The names of physical surfaces that are round about an axis, and stay so
     * under refinement. */
    std::vector<std::string> round_surfaces = {};
    /** That axis, as RoundAxis reads it. */
    std::string round_axis = "x";
    /** What coordinates in the file are multiplied by. */
    double scale = 1.;

    /** Whether both choose the same mesh. */
    bool
    operator==(const NamedMeshChoices &other) const;
  };



  /**
   * The mesh in a file of Gmsh with the meaning its physical names give it.
   *
   * A physical volume is named "<tissue>" or "<tissue> <segment>", a physical
   * surface by its boundary, or "symmetry x", "symmetry y", "symmetry z", or
   * "cavity <segment>" around a chamber without cells. The rest of the boundary is
   * called "free".
   */
  struct NamedMesh
  {
    /** Scaled [mm]. */
    std::vector<dealii::Point<dim>> vertices;
    /** With the material id of their Region. */
    std::vector<dealii::CellData<dim>> cells;
    /** The shape of each, where the file says more than vertices; else empty. */
    std::vector<CurvedCell> curved_cells;

    /** As Geometry::tissues(), in the order of the tags of their volumes. */
    std::vector<TissueName> tissues;
    /** See Geometry::boundary_names(). */
    std::vector<std::string> boundary_names;
    /** See Geometry::symmetry_planes(). */
    std::vector<SymmetryPlane> symmetry_planes;
    /** See Geometry::cavities(). */
    std::vector<CavityWall> cavities;

    /** Of all faces at the boundary. */
    std::map<FaceKey, dealii::types::boundary_id> boundary_ids;
    /** Physical surfaces of the body that are no boundary, or not all of them,
     * and where they are, as the end of a sentence about the boundary. */
    std::map<std::string, std::string> inner_surfaces;
    /** The faces in what the user calls round surfaces. */
    std::set<FaceKey> round_faces;

    /** See mesh_sections(). */
    std::vector<SegmentSections> sections;
    /** See mesh_support_points(). */
    std::array<dealii::Point<dim>, 3> support_points;
    /** The least side of the box around the body [mm]. */
    double characteristic_length;
  };



  /**
   * Read and check a mesh. Throws ExcInput; @p section is where the choices
   * are parameters, for messages.
   */
  NamedMesh
  read_named_mesh(const std::string &section, const NamedMeshChoices &choices);
} // namespace lumbricus

#endif
