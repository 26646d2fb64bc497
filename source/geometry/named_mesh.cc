// SPDX-License-Identifier: LGPL-2.1-or-later
#include "named_mesh.h"

#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/names.h>
#include <lumbricus/core/user_text.h>
#include <lumbricus/parameters/expression.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/utilities.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cstddef>
#include <tuple>

#include "mesh_checks.h"
#include "mesh_measures.h"
#include "msh_file.h"
#include "named_boundaries.h"

namespace lumbricus
{
  namespace
  {
    std::string
    number_list(const std::set<unsigned int> &numbers)
    {
      std::string list;
      for (const unsigned int n : numbers)
        list += (list.empty() ? "" : ", ") + std::to_string(n);
      return list;
    }



    // From "wall 2" to "wall" and 2. Without a number it is 1.
    std::pair<std::string, unsigned int>
    tissue_and_segment(const std::string &name)
    {
      const auto last_word = name.find_last_of(" \t") + 1;
      if (last_word == name.size() ||
          name.find_first_not_of("0123456789", last_word) !=
            std::string::npos ||
          name.size() - last_word > 6)
        return {name, 1};
      return {dealii::Utilities::trim(name.substr(0, last_word)),
              std::stoul(name.substr(last_word))};
    }



    // Gives the cells and faces of a file their meaning, step by step.
    class Naming
    {
    public:
      Naming(const std::string &section, const NamedMeshChoices &choices);

      NamedMesh mesh;

    private:
      void
      name_tissues();

      void
      check_segments() const;

      void
      check_liquids() const;

      const NamedMeshChoices &choices;
      const MeshMessages      messages;
      const MshFile           file;
      std::set<unsigned int>  segments;
    };



    Naming::Naming(const std::string &section, const NamedMeshChoices &choices)
      : choices(choices)
      , messages(section, choices.file_name)
      , file(read_msh_file(section + "/File", choices.file_name))
    {
      mesh.vertices = file.vertices;
      mesh.cells    = file.cells;
      for (auto &X : mesh.vertices)
        X *= choices.scale;
      for (std::size_t c = 0; c < file.shapes.size(); ++c)
        {
          mesh.curved_cells.push_back(
            {{}, file.shapes[c], file.numbers[c]});
          CurvedCell &cell = mesh.curved_cells.back();
          std::copy_n(file.cells[c].vertices.begin(), 8, cell.vertices.begin());
          cell.shape.scale(choices.scale);
        }
      dealii::GridTools::invert_cells_with_negative_measure(mesh.vertices,
                                                            mesh.cells);

      // Names first: that they are missing or misspelt is the likelier mistake.
      name_tissues();
      check_segments();
      for (const std::string &wrong :
           {what_is_wrong(mesh.vertices, mesh.cells),
            what_is_wrong(mesh.curved_cells, mesh.cells)})
        if (!wrong.empty())
          messages.fail(wrong);
      check_liquids();
      name_boundaries(file, choices, messages, mesh);

      mesh.sections = mesh_sections(mesh.vertices,
                                    mesh.cells,
                                    mesh.tissues,
                                    *segments.rbegin(),
                                    mesh.cavities,
                                    mesh.boundary_ids,
                                    mesh.curved_cells);
      mesh.support_points =
        mesh_support_points(mesh.vertices, mesh.cells, mesh.tissues);
      const dealii::BoundingBox<dim> box(mesh.vertices);
      mesh.characteristic_length =
        std::min({box.side_length(0), box.side_length(1), box.side_length(2)});
      dealii::GridTools::consistently_order_cells(mesh.cells);
    }



    void
    Naming::name_tissues()
    {
      std::set<unsigned int> used;
      for (const auto &cell : mesh.cells)
        {
          used.insert(cell.material_id);
          if (file.volume_names.count(cell.material_id) > 0)
            continue;
          dealii::Point<dim> center;
          for (const unsigned int v : cell.vertices)
            center += mesh.vertices[v] / 8.;
          messages.fail(
            " has cells that are in no physical volume with a name, as "
            "that at " +
            point_text(center) +
            ". Give every volume a name as in 'Physical "
            "Volume(\"wall\") = {1};', and leave out 'Mesh.SaveAll'.");
        }

      // Tissues are numbered in the order of the tags.
      std::map<std::string, unsigned int> index;
      std::map<unsigned int, Region>      region_of_tag;
      for (const auto &[tag, name] : file.volume_names)
        {
          if (used.count(tag) == 0)
            continue;
          const auto [tissue, segment] = tissue_and_segment(name);
          const std::string unfit = unfit_name(tissue);
          if (segment == 0 || !unfit.empty())
            messages.fail(
              " has a physical volume '" + shortened(name) +
              "': " + (segment == 0 ? "the segment is 0" : "it " + unfit) +
              ". The name has to be that of a tissue, without '/', '#', '=' "
              "and commas, with the number of the segment, from 1, after it, "
              "as in 'wall 2'.");
          if (index.insert({tissue, mesh.tissues.size()}).second)
            mesh.tissues.push_back({tissue, false, false});
          segments.insert(segment);
          region_of_tag[tag] = {segment - 1, index[tissue]};
        }
      if (mesh.tissues.size() > Region::max_n_tissues)
        messages.fail(
          " has " + std::to_string(mesh.tissues.size()) +
          " tissues; there can be " + std::to_string(Region::max_n_tissues) +
          ". The number of a segment has to be the last word of the name "
          "of a physical volume, as in 'wall 2'.");

      for (auto &cell : mesh.cells)
        cell.material_id = region_of_tag[cell.material_id].material_id();

      std::set<std::string> names;
      for (const auto &entry : index)
        names.insert(entry.first);
      messages.check_list("Liquid tissues", "tissue", choices.liquids, names);
      messages.check_list("Wall layers", "tissue", choices.wall_layers, names);
      for (const std::string &name : choices.liquids)
        mesh.tissues[index[name]].liquid = true;
      for (const std::string &name : choices.wall_layers)
        {
          TissueName &tissue = mesh.tissues[index[name]];
          if (tissue.liquid && mesh.tissues.size() > 1)
            throw ExcInput(about_parameter(
              messages.section + "/Wall layers",
              "has '" + name + "', which is one of '" + messages.section +
                "/Liquid tissues' too. Remove it from one of them."));
          tissue.wall_layer = true;
        }
    }



    void
    Naming::check_segments() const
    {
      std::set<unsigned int> missing;
      for (const unsigned int s : segments)
        if (s > 1 && segments.count(s - 1) == 0)
          missing.insert(s - 1);
      if (!missing.empty())
        messages.fail(
          " has the segments " + number_list(segments) + ", but no segment " +
          number_list(missing) +
          ". Segments are counted from 1, without gaps; the number of a "
          "segment is the last word of the name of a physical volume, as "
          "in 'wall 2', and 1 where there is none.");
    }



    void
    Naming::check_liquids() const
    {
      std::map<unsigned int, unsigned int> segment_at;
      for (const auto &cell : mesh.cells)
        {
          const Region region = Region::of(cell.material_id);
          if (mesh.tissues[region.tissue].liquid)
            for (const unsigned int v : cell.vertices)
              {
                const unsigned int other =
                  segment_at.insert({v, region.segment}).first->second;
                if (other != region.segment)
                  messages.fail(
                    " has liquid of segment " +
                    std::to_string(std::min(other, region.segment) + 1) +
                    " and of segment " +
                    std::to_string(std::max(other, region.segment) + 1) +
                    " that touch at " + point_text(mesh.vertices[v]) +
                    ". Put a septum between them, or give them one number.");
              }
        }
    }
  } // namespace



  bool
  NamedMeshChoices::operator==(const NamedMeshChoices &other) const
  {
    const auto all = [](const NamedMeshChoices &c) {
      return std::tie(
        c.file_name, c.liquids, c.wall_layers, c.round_surfaces, c.round_axis,
        c.scale);
    };
    return all(*this) == all(other);
  }



  NamedMesh
  read_named_mesh(const std::string &section, const NamedMeshChoices &choices)
  {
    AssertThrow(!choices.file_name.empty(),
                ExcInput(about_parameter(
                  section + "/File",
                  "is not set. Give the path of a .msh file of Gmsh, from the "
                  "working directory.")));
    return Naming(section, choices).mesh;
  }
} // namespace lumbricus
