// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_named_boundaries_h
#define lumbricus_geometry_named_boundaries_h

#include "mesh_messages.h"
#include "msh_file.h"
#include "named_mesh.h"

namespace lumbricus
{
  /**
   * Give the faces of @p mesh, whose cells are those of @p file, the meaning of
   * the physical surfaces they are in: boundaries, planes of symmetry, and
   * the round surfaces of @p choices. Throws ExcInput.
   */
  void
  name_boundaries(const MshFile          &file,
                  const NamedMeshChoices &choices,
                  const MeshMessages     &messages,
                  NamedMesh              &mesh);
} // namespace lumbricus

#endif
