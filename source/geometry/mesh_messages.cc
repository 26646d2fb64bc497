// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh_messages.h"

#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/user_text.h>

namespace lumbricus
{
  MeshMessages::MeshMessages(const std::string &section,
                             const std::string &file_name)
    : section(section)
    , file_name(file_name)
  {}



  void
  MeshMessages::fail(const std::string &parameter,
                     const std::string &what) const
  {
    throw ExcInput(about_parameter(section + "/" + parameter,
                                   ": the mesh file '" + file_name + "'" +
                                     what));
  }



  void
  MeshMessages::fail(const std::string &what) const
  {
    fail("File", what);
  }



  void
  MeshMessages::check_list(const std::string              &parameter,
                           const std::string              &kind,
                           const std::vector<std::string> &names,
                           const std::set<std::string>    &known) const
  {
    for (const std::string &name : names)
      if (known.count(name) == 0)
        fail(parameter,
             " has no " + kind + " '" + name + "'. It has " +
               quoted_list(known) +
               ". Choose among these, leave the list empty if there is "
               "none, or add the name in Gmsh.");
  }
} // namespace lumbricus
