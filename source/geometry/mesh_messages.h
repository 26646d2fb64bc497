// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_mesh_messages_h
#define lumbricus_geometry_mesh_messages_h

#include <set>
#include <string>
#include <vector>

namespace lumbricus
{
  /** Messages about a mesh file, as ExcInput that names parameter and file. */
  struct MeshMessages
  {
    /** About the file @p file_name, which a parameter in @p section names. */
    MeshMessages(const std::string &section, const std::string &file_name);

    /** "Parameter '<section>/<parameter>': the mesh file so-and-so @p what". */
    [[noreturn]] void
    fail(const std::string &parameter, const std::string &what) const;

    /** Say that the mesh file so-and-so @p what, about the parameter that names
     * the file. */
    [[noreturn]] void
    fail(const std::string &what) const;

    /** All @p names in the list @p parameter have to be among those @p known,
     * which are of this @p kind. */
    void
    check_list(const std::string              &parameter,
               const std::string              &kind,
               const std::vector<std::string> &names,
               const std::set<std::string>    &known) const;

    /** Where the parameters about the mesh are. */
    const std::string section;
    /** As the user wrote it. */
    const std::string file_name;
  };
} // namespace lumbricus

#endif
