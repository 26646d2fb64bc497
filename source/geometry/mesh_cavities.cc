// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh_cavities.h"

#include <lumbricus/core/number_in_text.h>
#include <lumbricus/core/user_text.h>
#include <lumbricus/parameters/expression.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace lumbricus
{
  namespace
  {
    const std::string first_word = "cavity";

    // The segment, from 1, that a name which begins like that of a cavity means;
    // 0 where it means none.
    unsigned int
    segment_in(const std::string &name)
    {
      const auto blank = name.find_last_of(" \t");
      long long  segment;
      return blank == first_word.size() &&
                 read_number(name.substr(blank + 1), segment) && segment > 0 &&
                 segment < 1000000 ?
               segment :
               0;
    }



    bool
    begins_like_a_cavity(const std::string &name)
    {
      return name == first_word || name.compare(0, 7, first_word + " ") == 0 ||
             name.compare(0, 7, first_word + "\t") == 0;
    }



    // What is said of a cavity of which a face has cells on both sides, or that has
    // no faces.
    void
    check_faces_of(const std::string  &name,
                   const NameOfFace   &name_of_face,
                   const FaceCounts   &n_cells,
                   const MeshMessages &messages,
                   const NamedMesh    &mesh)
    {
      bool any = false;
      for (const auto &[key, its_name] : name_of_face)
        {
          if (its_name != name)
            continue;
          any = true;
          if (n_cells.at(key) == 1)
            continue;
          dealii::Point<dim> middle;
          for (const unsigned int v : key)
            middle += mesh.vertices[v] / 4.;
          messages.fail(" has the physical surface '" + name +
                        "' with cells on both sides, as at " +
                        point_text(middle) +
                        ". The chamber must have no cells: leave its volume out "
                        "of the mesh, or give the surface another name.");
        }
      if (!any)
        messages.fail(" has the physical surface '" + name +
                      "', but no cell has a face in it. Mesh it together with "
                      "the volume around the chamber, or remove its name.");
    }



    // For every segment whether it has cells of liquid.
    std::vector<bool>
    segments_with_liquid(const NamedMesh &mesh)
    {
      std::vector<bool> has_liquid;
      for (const auto &cell : mesh.cells)
        {
          const Region region = Region::of(cell.material_id);
          if (has_liquid.size() <= region.segment)
            has_liquid.resize(region.segment + 1, false);
          if (mesh.tissues[region.tissue].liquid)
            has_liquid[region.segment] = true;
        }
      return has_liquid;
    }
  } // namespace



  std::map<unsigned int, std::string>
  cavity_names(const MshFile      &file,
               const NameOfFace   &name_of_face,
               const FaceCounts   &n_cells,
               const MeshMessages &messages,
               const NamedMesh    &mesh)
  {
    const auto has_liquid = segments_with_liquid(mesh);
    const auto n_segments = has_liquid.size();

    std::map<unsigned int, std::string> names;
    for (const auto &entry : file.surface_names)
      {
        const std::string &name = entry.second;
        if (!begins_like_a_cavity(name))
          continue;
        const std::string  has     = " has a physical surface '" + name + "'";
        const unsigned int segment = segment_in(name);
        const std::string  number  = std::to_string(segment);
        if (segment == 0)
          messages.fail(
            has +
            ". Name the wall around a chamber without cells by its segment, as "
            "in 'cavity 1'; other surfaces must not begin with 'cavity'.");
        if (segment > n_segments)
          messages.fail(has + ", but no segment " + number + ": it has " +
                        std::to_string(n_segments) +
                        ". Give a physical volume around that chamber the "
                        "number, as in 'wall " +
                        number + "', or the surface that of its segment.");
        if (has_liquid[segment - 1])
          messages.fail(has + ", but the segment " + number +
                        " has cells of liquid too. A segment has one chamber: "
                        "remove the name or the cells, or take them out of "
                        "'Liquid tissues'.");
        if (!names.insert({segment - 1, name}).second)
          messages.fail(has + " and '" + names.at(segment - 1) +
                        "' for the same segment. A segment has one chamber: put "
                        "its wall into one physical surface, or number the "
                        "chambers.");
        check_faces_of(name, name_of_face, n_cells, messages, mesh);
      }

    if (!names.empty())
      for (unsigned int s = 0; s < names.rbegin()->first; ++s)
        if (names.count(s) == 0 && !has_liquid[s])
          messages.fail(" has the physical surface '" +
                        names.rbegin()->second +
                        "', but the segment " + std::to_string(s + 1) +
                        " before it has no chamber, neither 'cavity " +
                        std::to_string(s + 1) +
                        "' nor cells of liquid. Number chambers without gaps, "
                        "and let solid parts be of the segment of one of them.");
    return names;
  }



  void
  close_cavities(const std::map<unsigned int, std::string> &names,
                 const MeshMessages                        &messages,
                 NamedMesh                                 &mesh)
  {
    if (mesh.cavities.empty())
      return;
    dealii::Point<dim> origin;
    for (const SymmetryPlane &plane : mesh.symmetry_planes)
      for (const auto &[key, id] : mesh.boundary_ids)
        if (id == plane.boundary)
          {
            origin[plane.direction] = mesh.vertices[key[0]][plane.direction];
            break;
          }

    // Faces by their corners, in the order of deal.II; edges as pairs of these.
    constexpr unsigned int lines[4][2] = {{0, 1}, {2, 3}, {0, 2}, {1, 3}};
    using Edge                         = std::pair<unsigned int, unsigned int>;
    for (CavityWall &wall : mesh.cavities)
      {
        wall.origin = origin;
        std::map<Edge, unsigned int> n_faces;
        double                       size = 0.;
        for (const auto &cell : mesh.cells)
          for (unsigned int f = 0; f < 6; ++f)
            {
              const auto id = mesh.boundary_ids.find(face_key(cell, f));
              if (id == mesh.boundary_ids.end() || id->second != wall.boundary)
                continue;
              for (const auto &line : lines)
                {
                  unsigned int v[2];
                  for (unsigned int i = 0; i < 2; ++i)
                    v[i] = cell.vertices[dealii::GeometryInfo<
                      dim>::face_to_cell_vertices(f, line[i])];
                  ++n_faces[std::minmax(v[0], v[1])];
                  size = std::max(
                    size, mesh.vertices[v[0]].distance(mesh.vertices[v[1]]));
                }
            }
        for (const auto &[edge, n] : n_faces)
          {
            const auto &a = mesh.vertices[edge.first];
            const auto &b = mesh.vertices[edge.second];
            const bool  in_plane =
              std::any_of(mesh.symmetry_planes.begin(),
                          mesh.symmetry_planes.end(),
                          [&](const SymmetryPlane &plane) {
                            const unsigned int d = plane.direction;
                            return std::abs(a[d] - origin[d]) < 1e-6 * size &&
                                   std::abs(b[d] - origin[d]) < 1e-6 * size;
                          });
            if (n % 2 != 0 && !in_plane)
              messages.fail(" has the physical surface '" +
                            names.at(wall.segment) +
                            "', which does not close its chamber: it ends at "
                            "the edge from " +
                            point_text(a) + " to " + point_text(b) +
                            ", which is in no plane of mirror symmetry. Which "
                            "surface is missing?");
          }
      }
  }
} // namespace lumbricus
