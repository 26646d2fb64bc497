// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_tests_write_msh_h
#define lumbricus_tests_write_msh_h

#include <lumbricus/geometry/geometry.h>

#include <deal.II/base/numbers.h>
#include <deal.II/grid/tria.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <string>
#include <vector>

namespace lumbricus
{
  /** A physical group: its elements, each with its nodes in Gmsh's order. */
  struct MshGroup
  {
    unsigned int                           dimension;
    std::string                            name;
    std::vector<std::vector<unsigned int>> elements = {};
  };



  /** Nodes and physical groups as a text file of Gmsh, version 2.2 or 4.1. */
  inline void
  write_msh(const std::string                     &file_name,
            const std::string                     &version,
            const std::vector<dealii::Point<dim>> &nodes,
            const std::vector<MshGroup>           &groups)
  {
    std::ofstream out(file_name);
    out.precision(17);
    out << "$MeshFormat\n"
        << version << " 0 8\n$EndMeshFormat\n$PhysicalNames\n"
        << groups.size() << "\n";
    std::size_t n_elements = 0, n_surfaces = 0;
    for (std::size_t g = 0; g < groups.size(); ++g)
      {
        out << groups[g].dimension << " " << g + 1 << " \"" << groups[g].name
            << "\"\n";
        n_elements += groups[g].elements.size();
        n_surfaces += groups[g].dimension == 2;
      }
    out << "$EndPhysicalNames\n";

    // Numbers of nodes and elements need not begin at one nor be in order.
    const auto node_number = [&](const std::size_t i) {
      return 3 * (nodes.size() - i);
    };
    const auto element_type = [](const MshGroup &group) {
      return group.dimension == 2 ? 3 : 5;
    };
    const auto write_nodes_of = [&](const std::vector<unsigned int> &element) {
      for (const unsigned int v : element)
        out << " " << node_number(v);
      out << "\n";
    };
    std::size_t number = 7;
    if (version == "2.2")
      {
        out << "$Nodes\n" << nodes.size() << "\n";
        for (std::size_t i = 0; i < nodes.size(); ++i)
          out << node_number(i) << " " << nodes[i] << "\n";
        out << "$EndNodes\n$Elements\n" << n_elements << "\n";
        for (std::size_t g = 0; g < groups.size(); ++g)
          for (const auto &element : groups[g].elements)
            {
              out << number++ << " " << element_type(groups[g]) << " 2 "
                  << g + 1 << " 1";
              write_nodes_of(element);
            }
      }
    else
      {
        out << "$Entities\n0 0 " << n_surfaces << " "
            << groups.size() - n_surfaces << "\n";
        for (const unsigned int dimension : {2, 3})
          for (std::size_t g = 0; g < groups.size(); ++g)
            if (groups[g].dimension == dimension)
              out << g + 11 << " 0 0 0 1 1 1 1 " << g + 1 << " 0\n";
        out << "$EndEntities\n$Nodes\n1 " << nodes.size() << " 3 "
            << 3 * nodes.size() << "\n3 11 0 " << nodes.size() << "\n";
        for (std::size_t i = 0; i < nodes.size(); ++i)
          out << node_number(i) << "\n";
        for (const auto &X : nodes)
          out << X << "\n";
        out << "$EndNodes\n$Elements\n"
            << groups.size() << " " << n_elements << " 7 " << 6 + n_elements
            << "\n";
        for (std::size_t g = 0; g < groups.size(); ++g)
          {
            out << groups[g].dimension << " " << g + 11 << " "
                << element_type(groups[g]) << " " << groups[g].elements.size()
                << "\n";
            for (const auto &element : groups[g].elements)
              {
                out << number++;
                write_nodes_of(element);
              }
          }
      }
    out << "$EndElements\n";
  }



  /**
   * The coarse mesh of @p geometry as a file of Gmsh. Where cells have curved
   * faces inside the body these are in the physical surface "inner circles".
   * Every third cell is turned inside out, as a file may have them.
   */
  inline void
  write_msh(const std::string &file_name,
            const std::string &version,
            const Geometry    &geometry)
  {
    dealii::Triangulation<dim> mesh;
    geometry.create_coarse_mesh(mesh);
    const auto tissues = geometry.tissues();

    std::map<std::pair<unsigned int, std::string>, MshGroup> groups;
    const auto add = [&](const unsigned int               dimension,
                         const std::string               &name,
                         const std::vector<unsigned int> &nodes) {
      auto &group     = groups[{dimension, name}];
      group.dimension = dimension;
      group.name      = name;
      group.elements.push_back(nodes);
    };
    const auto is_circle = [](const auto &face) {
      const auto r = [&](const unsigned int v) {
        return std::hypot(face->vertex(v)[1], face->vertex(v)[2]);
      };
      return face->manifold_id() != dealii::numbers::flat_manifold_id &&
             std::abs(r(0) - r(1)) < 1e-9 && std::abs(r(0) - r(2)) < 1e-9 &&
             std::abs(r(0) - r(3)) < 1e-9;
    };
    for (const auto &cell : mesh.active_cell_iterators())
      {
        const Region              region = Region::of(cell->material_id());
        std::vector<unsigned int> nodes;
        for (const unsigned int v : {0, 1, 3, 2, 4, 5, 7, 6})
          nodes.push_back(cell->vertex_index(v));
        if (cell->active_cell_index() % 3 == 1)
          std::rotate(nodes.begin(), nodes.begin() + 4, nodes.end());
        add(3,
            tissues[region.tissue].name +
              (region.segment > 0 ? " " + std::to_string(region.segment + 1) :
                                    ""),
            nodes);
        for (const unsigned int f : cell->face_indices())
          {
            const auto                face = cell->face(f);
            std::vector<unsigned int> corners;
            for (const unsigned int v : {0, 1, 3, 2})
              corners.push_back(face->vertex_index(v));
            const unsigned int id    = face->boundary_id();
            const auto         names = geometry.boundary_names();
            if (!face->at_boundary())
              {
                // Met from both sides.
                if (is_circle(face) && cell->neighbor(f)->active_cell_index() <
                                         cell->active_cell_index())
                  add(2, "inner circles", corners);
              }
            else if (id < names.size())
              add(2, names[id], corners);
            else
              {
                for (const auto &plane : geometry.symmetry_planes())
                  if (plane.boundary == id)
                    add(2,
                        std::string("symmetry ") + "xyz"[plane.direction],
                        corners);
                for (const auto &wall : geometry.cavities())
                  if (wall.boundary == id)
                    add(2,
                        "cavity " + std::to_string(wall.segment + 1),
                        corners);
              }
          }
      }
    std::vector<MshGroup> list;
    for (const auto &group : groups)
      list.push_back(group.second);
    write_msh(file_name, version, mesh.get_vertices(), list);
  }
} // namespace lumbricus

#endif
