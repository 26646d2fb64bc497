// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/expression.h>
#include <lumbricus/geometry/mesh_checks.h>
#include <lumbricus/geometry/mesh_measures.h>
#include <lumbricus/geometry/msh_file.h>
#include <lumbricus/geometry/physical_names.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/utilities.h>
#include <deal.II/grid/grid_tools.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <tuple>

namespace lumbricus
{
  namespace
  {
    const std::string free_boundary = "free";

    const std::array<std::string, dim> symmetry_names = {
      {"symmetry x", "symmetry y", "symmetry z"}};



    std::string
    quoted_list(const std::set<std::string> &names)
    {
      std::string list;
      for (const std::string &name : names)
        list += (list.empty() ? "'" : ", '") + name + "'";
      return list.empty() ? "none" : list;
    }



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
      [[noreturn]] void
      fail(const std::string &parameter, const std::string &what) const
      {
        throw ExcInput("Parameter '" + section + "/" + parameter +
                       "': the mesh file '" + choices.file_name + "'" + what);
      }

      [[noreturn]] void
      fail(const std::string &what) const
      {
        fail("File", what);
      }

      // All names in the list @p parameter have to be among those @p known.
      void
      check_list(const std::string              &parameter,
                 const std::string              &kind,
                 const std::vector<std::string> &names,
                 const std::set<std::string>    &known) const;

      void
      name_tissues();

      void
      check_segments() const;

      void
      check_liquids() const;

      void
      name_boundaries();

      void
      check_symmetry_planes() const;

      void
      find_round_faces();

      const std::string             &section;
      const NamedMeshChoices        &choices;
      const MshFile                  file;
      std::set<unsigned int>         segments;
      std::map<FaceKey, std::string> name_of_face;
    };



    Naming::Naming(const std::string &section, const NamedMeshChoices &choices)
      : section(section)
      , choices(choices)
      , file(read_msh_file(section + "/File", choices.file_name))
    {
      mesh.vertices = file.vertices;
      mesh.cells    = file.cells;
      for (auto &X : mesh.vertices)
        X *= choices.scale;
      dealii::GridTools::invert_cells_with_negative_measure(mesh.vertices,
                                                            mesh.cells);

      // Names first: that they are missing or misspelt is the likelier mistake.
      name_tissues();
      check_segments();
      const std::string wrong = what_is_wrong(mesh.vertices, mesh.cells);
      if (!wrong.empty())
        fail(wrong);
      check_liquids();
      name_boundaries();
      check_symmetry_planes();
      find_round_faces();

      mesh.sections = mesh_sections(mesh.vertices,
                                    mesh.cells,
                                    mesh.tissues,
                                    *segments.rbegin());
      mesh.support_points =
        mesh_support_points(mesh.vertices, mesh.cells, mesh.tissues);
      const dealii::BoundingBox<dim> box(mesh.vertices);
      mesh.characteristic_length =
        std::min({box.side_length(0), box.side_length(1), box.side_length(2)});
      dealii::GridTools::consistently_order_cells(mesh.cells);
    }



    void
    Naming::check_list(const std::string              &parameter,
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
          fail(" has cells that are in no physical volume with a name, as "
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
          if (tissue.empty() || segment == 0)
            fail(" has a physical volume '" + name +
                 "'. The name has to be that of a tissue, with the number of "
                 "the segment, from 1, after it, as in 'wall 2'.");
          if (index.insert({tissue, mesh.tissues.size()}).second)
            mesh.tissues.push_back({tissue, false, false});
          segments.insert(segment);
          region_of_tag[tag] = {segment - 1, index[tissue]};
        }
      if (mesh.tissues.size() > Region::max_n_tissues)
        fail(" has " + std::to_string(mesh.tissues.size()) +
             " tissues; there can be " + std::to_string(Region::max_n_tissues) +
             ". The number of a segment has to be the last word of the name "
             "of a physical volume, as in 'wall 2'.");

      for (auto &cell : mesh.cells)
        cell.material_id = region_of_tag[cell.material_id].material_id();

      std::set<std::string> names;
      for (const auto &entry : index)
        names.insert(entry.first);
      check_list("Liquid tissues", "tissue", choices.liquids, names);
      check_list("Wall layers", "tissue", choices.wall_layers, names);
      for (const std::string &name : choices.liquids)
        mesh.tissues[index[name]].liquid = true;
      for (const std::string &name : choices.wall_layers)
        {
          TissueName &tissue = mesh.tissues[index[name]];
          if (tissue.liquid && mesh.tissues.size() > 1)
            throw ExcInput("Parameter '" + section + "/Wall layers' has '" +
                           name + "', which is one of '" + section +
                           "/Liquid tissues' too. Remove it from one of "
                           "them.");
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
        fail(" has the segments " + number_list(segments) +
             ", but no segment " + number_list(missing) +
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
                  fail(" has liquid of segment " +
                       std::to_string(std::min(other, region.segment) + 1) +
                       " and of segment " +
                       std::to_string(std::max(other, region.segment) + 1) +
                       " that touch at " + point_text(mesh.vertices[v]) +
                       ". Put a septum between them, or give them one number.");
              }
        }
    }



    void
    Naming::name_boundaries()
    {
      std::map<FaceKey, unsigned int> n_cells;
      for (const auto &cell : mesh.cells)
        for (unsigned int f = 0; f < 6; ++f)
          ++n_cells[face_key(cell, f)];

      for (const auto &face : file.faces)
        {
          const auto name = file.surface_names.find(face.tag);
          if (name == file.surface_names.end() ||
              n_cells.count(face.vertices) == 0)
            continue;
          const auto &known =
            name_of_face.insert({face.vertices, name->second}).first->second;
          if (known != name->second)
            fail(" has a face in two physical surfaces, '" + known + "' and '" +
                 name->second + "'. Put it into one.");
        }

      // The names of the boundary in the order of their tags, then the planes.
      std::set<std::string> used;
      for (const auto &[key, n] : n_cells)
        if (n == 1)
          {
            const auto name = name_of_face.find(key);
            used.insert(name == name_of_face.end() ? free_boundary :
                                                     name->second);
          }
      std::map<std::string, dealii::types::boundary_id> ids;
      const auto add = [&](const std::string &name) {
        const bool plane =
          std::find(symmetry_names.begin(), symmetry_names.end(), name) !=
          symmetry_names.end();
        if (!plane && used.count(name) > 0 &&
            ids.insert({name, mesh.boundary_names.size()}).second)
          mesh.boundary_names.push_back(name);
        if (!plane && name.compare(0, 8, "symmetry") == 0)
          fail(" has a physical surface '" + name +
               "'. Name a plane of mirror symmetry 'symmetry x', 'symmetry y' "
               "or 'symmetry z', by the direction of its normal; other "
               "surfaces must not begin with 'symmetry'.");
      };
      for (const auto &entry : file.surface_names)
        add(entry.second);
      add(free_boundary);
      for (unsigned int d = 0; d < dim; ++d)
        if (used.count(symmetry_names[d]) > 0)
          {
            const dealii::types::boundary_id id =
              mesh.boundary_names.size() + mesh.symmetry_planes.size();
            ids[symmetry_names[d]] = id;
            mesh.symmetry_planes.push_back({id, d});
          }

      for (const auto &[key, n] : n_cells)
        if (n == 1)
          {
            const auto name = name_of_face.find(key);
            mesh.boundary_ids[key] =
              ids.at(name == name_of_face.end() ? free_boundary : name->second);
          }
    }



    void
    Naming::check_symmetry_planes() const
    {
      const dealii::BoundingBox<dim> box(mesh.vertices);
      for (const SymmetryPlane &plane : mesh.symmetry_planes)
        {
          const unsigned int d     = plane.direction;
          double             least = std::numeric_limits<double>::max();
          double             most  = -least;
          for (const auto &[key, id] : mesh.boundary_ids)
            if (id == plane.boundary)
              for (const unsigned int v : key)
                {
                  least = std::min(least, mesh.vertices[v][d]);
                  most  = std::max(most, mesh.vertices[v][d]);
                }
          const double lower = box.lower_bound(d), upper = box.upper_bound(d);
          const double tolerance = 1e-6 * (upper - lower);
          const std::string axis(1, "xyz"[d]);
          const auto        complain = [&](const std::string &what) {
            std::ostringstream range;
            range << " has the plane of mirror symmetry '" << symmetry_names[d]
                  << "' " << what << ": it reaches from " << axis << " = "
                  << least << " to " << most;
            if (least - lower > tolerance && upper - most > tolerance)
              range << ", and the body from " << lower << " to " << upper;
            range << ". All of its faces have to be in one plane " << axis
                  << " = const at one end of the body.";
            fail(range.str());
          };
          if (most - least > tolerance)
            complain("that is not flat");
          if (least - lower > tolerance && upper - most > tolerance)
            complain("inside the body");
        }
    }



    void
    Naming::find_round_faces()
    {
      std::set<std::string> names;
      for (const auto &entry : name_of_face)
        names.insert(entry.second);
      check_list("Round surfaces",
                 "physical surface",
                 choices.round_surfaces,
                 names);

      const std::set<std::string> round(choices.round_surfaces.begin(),
                                        choices.round_surfaces.end());
      for (const auto &[key, name] : name_of_face)
        if (round.count(name) > 0)
          {
            for (const unsigned int v : key)
              {
                const auto &X = mesh.vertices[v];
                if (std::hypot(X[1], X[2]) < 1e-6 * choices.scale)
                  fail("Round surfaces",
                       " has the physical surface '" + name +
                         "' on the x axis, at " + point_text(X) +
                         ", and so it cannot be round about it. Remove it "
                         "from the list.");
              }
            mesh.round_faces.insert(key);
          }
    }
  } // namespace



  bool
  NamedMeshChoices::operator==(const NamedMeshChoices &other) const
  {
    const auto all = [](const NamedMeshChoices &c) {
      return std::tie(
        c.file_name, c.liquids, c.wall_layers, c.round_surfaces, c.scale);
    };
    return all(*this) == all(other);
  }



  NamedMesh
  read_named_mesh(const std::string &section, const NamedMeshChoices &choices)
  {
    AssertThrow(!choices.file_name.empty(),
                ExcInput("Parameter '" + section +
                         "/File' is not set. Give the path of a .msh file of "
                         "Gmsh, from the working directory."));
    return Naming(section, choices).mesh;
  }
} // namespace lumbricus
