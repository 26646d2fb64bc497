// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_mesh_cavities_h
#define lumbricus_geometry_mesh_cavities_h

#include <map>
#include <string>

#include "mesh_messages.h"
#include "msh_file.h"
#include "named_mesh.h"

namespace lumbricus
{
  /** Names of physical surfaces by their faces. */
  using NameOfFace = std::map<FaceKey, std::string>;
  /** How many cells there are at a face. */
  using FaceCounts = std::map<FaceKey, unsigned int>;

  /**
   * The physical surfaces "cavity 1", "cavity 2", ... of @p file by segments, from
   * zero: the walls around chambers without cells. Throws ExcInput about a name
   * that begins like this but is none of these, is there twice, has no faces or
   * faces with cells on both sides, or whose segment is not there; and about a
   * segment that is left out between others, and has no liquid.
   */
  std::map<unsigned int, std::string>
  cavity_names(const MshFile      &file,
               const NameOfFace   &name_of_face,
               const FaceCounts   &n_cells,
               const MeshMessages &messages,
               const NamedMesh    &mesh);

  /**
   * Set CavityWall::origin. Throws ExcInput where a wall has an edge at which it
   * ends and that lies in no plane of symmetry.
   */
  void
  close_cavities(const std::map<unsigned int, std::string> &names,
                 const MeshMessages                        &messages,
                 NamedMesh                                 &mesh);
} // namespace lumbricus

#endif
