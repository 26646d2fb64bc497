// SPDX-License-Identifier: LGPL-2.1-or-later
#include "msh_nodes.h"

namespace lumbricus
{
  void
  MshNodes::read_list(MshLines &in, const std::string &name)
  {
    const bool parametric = name == "$ParametricNodes";
    in.begin_section(name);
    const std::size_t n_nodes = in.get_count();
    in.need_end_of_line();
    for (std::size_t n = 0; n < n_nodes; ++n)
      {
        in.need();
        add(in, in.get_count());
        // Where on which curve or surface the node is means nothing here.
        if (!parametric)
          in.need_end_of_line();
      }
  }



  void
  MshNodes::read_blocks(MshLines &in)
  {
    in.begin_section("$Nodes");
    const std::size_t n_blocks = in.get_count(), n_nodes = in.get_count();
    std::size_t       n_read = 0;
    for (std::size_t block = 0; block < n_blocks; ++block)
      {
        in.need();
        in.get_integer(), in.get_integer();
        const bool               parametric = in.get_integer() != 0;
        std::vector<std::size_t> nodes;
        const std::size_t        n = in.get_count();
        in.need_end_of_line();
        for (std::size_t i = 0; i < n; ++i)
          {
            in.need();
            nodes.push_back(in.get_count());
            in.need_end_of_line();
          }
        for (const std::size_t node : nodes)
          {
            in.need();
            add(in, node);
            if (!parametric)
              in.need_end_of_line();
          }
        n_read += n;
      }
    in.check_count("nodes", n_read, n_nodes);
  }



  void
  MshNodes::add(MshLines &in, const std::size_t node)
  {
    dealii::Point<dim> X;
    for (unsigned int d = 0; d < dim; ++d)
      X[d] = in.get_number();
    if (!vertex_of_node.insert({node, vertices.size()}).second)
      in.fail_in_line("has node " + std::to_string(node) +
                      " a second time. Every node has a number of its own: "
                      "write the file again.");
    vertices.push_back(X);
  }



  unsigned int
  MshNodes::get_vertex(MshLines &in) const
  {
    const auto found = vertex_of_node.find(in.get_count());
    if (found == vertex_of_node.end())
      in.fail_in_line("names a node the file does not have. Write it again.");
    return found->second;
  }
} // namespace lumbricus
