// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_msh_nodes_h
#define lumbricus_geometry_msh_nodes_h

#include <lumbricus/core/dimension.h>

#include <deal.II/base/point.h>

#include <string>
#include <unordered_map>
#include <vector>

#include "msh_lines.h"

namespace lumbricus
{
  /** The nodes of a file of Gmsh, whose numbers may be any. */
  class MshNodes
  {
  public:
    /** Read the section @p name of the format 2.2, "$Nodes" or
     * "$ParametricNodes", up to its last line. Throws ExcInput. */
    void
    read_list(MshLines &in, const std::string &name);

    /** Read the section "$Nodes" of the format 4.1. Throws ExcInput. */
    void
    read_blocks(MshLines &in);

    /** The next number in the line is that of a node: its place in points().
     * Throws ExcInput where there is no such node. */
    unsigned int
    get_vertex(MshLines &in) const;

    /** All of them, in the order of the file. */
    const std::vector<dealii::Point<dim>> &
    points() const
    {
      return vertices;
    }

  private:
    void
    add(MshLines &in, const std::size_t node);

    std::vector<dealii::Point<dim>>               vertices;
    std::unordered_map<std::size_t, unsigned int> vertex_of_node;
  };
} // namespace lumbricus

#endif
