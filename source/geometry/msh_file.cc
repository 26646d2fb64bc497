// SPDX-License-Identifier: LGPL-2.1-or-later
#include "msh_file.h"

#include <deal.II/base/types.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <unordered_map>
#include <utility>

#include "msh_elements.h"
#include "msh_lines.h"
#include "msh_nodes.h"

namespace lumbricus
{
  namespace
  {
    // From deal.II's number of a vertex of a hexahedron to Gmsh's.
    constexpr std::array<unsigned int, 8> gmsh_vertex = {
      {0, 1, 3, 2, 4, 5, 7, 6}};



    // Reads a file section by section.
    class Reader
    {
    public:
      explicit Reader(MshLines &in)
        : in(in)
      {
        // Nothing in a section of a binary file is a line.
        check_format();
        while (in.next())
          read_section(in.trimmed());
      }

      MshFile
      result();

    private:
      // Tags are negative where a surface is turned around.
      unsigned int
      get_tag()
      {
        return std::abs(in.get_integer());
      }

      void
      check_format();

      void
      read_section(const std::string &name);

      void
      read_names();

      void
      read_entities();

      void
      read_elements();

      void
      read_element_blocks();

      const MshElementType &
      get_type();

      unsigned int
      tag_of_entity(const int dimension, const int entity) const;

      void
      add_element(const std::size_t     number,
                  const MshElementType &type,
                  const unsigned int    tag);

      std::vector<unsigned int>
      get_vertices(const unsigned int n);

      void
      add_hexahedron(const std::size_t                number,
                     const MshElementType            &type,
                     const unsigned int               tag,
                     const std::vector<unsigned int> &of_gmsh);

      void
      check_number(const std::size_t                number,
                   const MshElementType            &type,
                   const std::vector<unsigned int> &vertices);

      void
      sort_out_faces();

      void
      check_elements() const;

      void
      keep_used_vertices();

      MshLines &in;
      bool      version4 = false;

      MshFile  file;
      MshNodes nodes;
      /** By dimension and number of an entity; 0 where it is in no group. */
      std::map<std::pair<int, int>, unsigned int> tags;
      /** The vertices of the elements that are kept, by their numbers. */
      std::unordered_map<std::size_t, std::vector<unsigned int>> elements;
      UnusableVolumes                                            unusable;
      /** How many hexahedra there are of so many nodes. */
      std::map<unsigned int, std::size_t> n_hexahedra;
      /** The kind of each of the faces. */
      std::vector<const MshElementType *> kinds_of_faces;
    };



    void
    Reader::check_format()
    {
      if (!in.next() || in.trimmed() != "$MeshFormat")
        in.fail(
          " is not a file of Gmsh: it does not begin with '$MeshFormat'. " +
          MshLines::how_to_write);
      in.need();
      const double version = in.get_number();
      version4             = std::abs(version - 4.1) < 1e-6;
      if (!version4 && !(version > 1.9 && version < 2.9))
        in.fail(" has Gmsh's format " + in.first_word() +
                "; the formats 2.2 and 4.1 can be read. " +
                MshLines::how_to_write);
      if (in.get_integer() != 0)
        in.fail(" is binary; text can be read. " + MshLines::how_to_write);
      in.end_section("$MeshFormat");
    }



    void
    Reader::read_section(const std::string &name)
    {
      if (name.empty() || name[0] != '$')
        in.fail_in_line(in.shown() + ", is not the begin of a section. " +
                        MshLines::how_to_write);
      if (name == "$PartitionedEntities")
        in.fail(
          " has been partitioned. Write it without partitions: the program "
          "makes its own.");

      if (name == "$PhysicalNames")
        read_names();
      else if (name == "$Entities" && version4)
        read_entities();
      else if (name == "$Nodes" && version4)
        nodes.read_blocks(in);
      else if (name == "$Nodes" || (name == "$ParametricNodes" && !version4))
        nodes.read_list(in, name);
      else if (name == "$Elements" && version4)
        read_element_blocks();
      else if (name == "$Elements")
        read_elements();
      else
        {
          // Whatever else programs write.
          const std::string end = "$End" + name.substr(1);
          while (in.trimmed() != end)
            in.need();
          return;
        }
      in.end_section(name);
    }



    void
    Reader::read_names()
    {
      in.begin_section("$PhysicalNames");
      for (std::size_t n = in.get_count(); n > 0; --n)
        {
          in.need();
          const int         dimension = in.get_integer();
          const auto        tag       = get_tag();
          const std::string line      = in.trimmed();
          const auto        first = line.find('"'), last = line.rfind('"');
          if (first == last || last + 1 != line.size())
            in.fail_in_line("has no name in quotation marks. " +
                            MshLines::how_to_write);
          const std::string name =
            dealii::Utilities::trim(line.substr(first + 1, last - first - 1));
          if (tag == 0 || dimension < 0 || dimension > 3)
            in.fail_in_line(in.shown() +
                            ", has no physical group: its dimension is 0 to 3, "
                            "and its number not 0. " +
                            MshLines::how_to_write);
          auto &names = dimension == 3 ? file.volume_names : file.surface_names;
          if (dimension >= 2 && !names.insert({tag, name}).second)
            in.fail_in_line("names the physical group " + std::to_string(tag) +
                            " of dimension " + std::to_string(dimension) +
                            " a second time. Give it one name.");
        }
    }



    void
    Reader::read_entities()
    {
      in.begin_section("$Entities");
      std::array<std::size_t, 4> n_entities;
      for (std::size_t &n : n_entities)
        n = in.get_count();
      in.need_end_of_line();
      for (int d = 0; d < 4; ++d)
        for (std::size_t n = n_entities[d]; n > 0; --n)
          {
            in.need();
            const int entity = in.get_integer();
            // A point, or the corners of a box.
            for (unsigned int i = 0; i < (d == 0 ? 3 : 6); ++i)
              in.get_number();
            const std::size_t n_tags = in.get_count();
            if (n_tags > 1 && d >= 2)
              in.fail_in_line(
                (d == 2 ? "has a surface" : "has a volume") +
                std::string(" in two physical groups. Put it into "
                            "one."));
            if (!tags.insert({{d, entity}, n_tags == 1 ? get_tag() : 0}).second)
              in.fail_in_line("has the entity " + std::to_string(entity) +
                              " of dimension " + std::to_string(d) +
                              " a second time. Write the file again.");
          }
    }



    void
    Reader::read_elements()
    {
      in.begin_section("$Elements");
      const std::size_t n_elements = in.get_count();
      in.need_end_of_line();
      for (std::size_t n = 0; n < n_elements; ++n)
        {
          in.need();
          const std::size_t     number = in.get_count();
          const MshElementType &type   = get_type();
          unsigned int          tag    = 0;
          for (std::size_t i = 0, n_tags = in.get_count(); i < n_tags; ++i)
            {
              const unsigned int other = get_tag();
              tag                      = i == 0 ? other : tag;
            }
          add_element(number, type, tag);
        }
    }



    void
    Reader::read_element_blocks()
    {
      if (!in.had_section("$Entities"))
        in.fail(
          " has no section '$Entities' before its elements, so nothing says "
          "which physical group they are in. Programs that leave it out, as "
          "meshio does, can write the format 2.2, which needs none: "
          "meshio.write(file, mesh, file_format=\"gmsh22\").");
      in.begin_section("$Elements");
      const std::size_t n_blocks = in.get_count(), n_elements = in.get_count();
      std::size_t       n_read = 0;
      for (std::size_t block = 0; block < n_blocks; ++block)
        {
          in.need();
          const int             dimension = in.get_integer();
          const int             entity    = in.get_integer();
          const MshElementType &type      = get_type();
          if (dimension != type.dimension)
            in.fail_in_line("has " + type.name + " in an entity of dimension " +
                            std::to_string(dimension) +
                            ". Write the file again.");
          const unsigned int tag = tag_of_entity(dimension, entity);
          const std::size_t  n   = in.get_count();
          in.need_end_of_line();
          for (std::size_t i = 0; i < n; ++i)
            {
              in.need();
              add_element(in.get_count(), type, tag);
            }
          n_read += n;
        }
      in.check_count("elements", n_read, n_elements);
    }



    const MshElementType &
    Reader::get_type()
    {
      const int             number = in.get_integer();
      const MshElementType *type   = MshElementType::find(number);
      if (type == nullptr)
        in.fail_in_line("has an element of type " + std::to_string(number) +
                        ", which is none of Gmsh's. " + MshLines::how_to_write);
      return *type;
    }



    unsigned int
    Reader::tag_of_entity(const int dimension, const int entity) const
    {
      const auto found = tags.find({dimension, entity});
      if (found == tags.end() && dimension >= 2)
        in.fail_in_line("has elements of the entity " + std::to_string(entity) +
                        " of dimension " + std::to_string(dimension) +
                        ", which '$Entities' does not have. Write the file "
                        "again.");
      return found == tags.end() ? 0 : found->second;
    }



    std::vector<unsigned int>
    Reader::get_vertices(const unsigned int n)
    {
      std::vector<unsigned int> vertices(n);
      for (unsigned int &v : vertices)
        v = nodes.get_vertex(in);
      return vertices;
    }



    void
    Reader::check_number(const std::size_t                number,
                         const MshElementType            &type,
                         const std::vector<unsigned int> &vertices)
    {
      auto sorted = vertices;
      std::sort(sorted.begin(), sorted.end());
      if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
        in.fail_in_line("has an element with one node twice. " +
                        UnusableVolumes::how_to_mesh);

      // A face in two physical surfaces is there once for each.
      const auto entry = elements.insert({number, sorted});
      if (!entry.second &&
          (type.dimension == 3 || entry.first->second != sorted))
        in.fail_in_line("has element " + std::to_string(number) +
                        " a second time. Every element has a number of its "
                        "own, and is in one physical group: write the file "
                        "again.");
    }



    void
    Reader::add_element(const std::size_t     number,
                        const MshElementType &type,
                        const unsigned int    tag)
    {
      if (type.dimension == 3 && type.n_nodes > 0)
        {
          const auto of_gmsh = get_vertices(type.n_nodes);
          in.need_end_of_line();
          check_number(number, type, of_gmsh);
          add_hexahedron(number, type, tag, of_gmsh);
        }
      else if (type.dimension == 2 && type.n_nodes > 0)
        {
          const auto all = get_vertices(type.n_nodes);
          in.need_end_of_line();
          if (tag == 0)
            return;
          check_number(number, type, all);
          MshFile::Face face;
          std::copy_n(all.begin(), face.vertices.size(), face.vertices.begin());
          std::sort(face.vertices.begin(), face.vertices.end());
          face.tag = tag;
          file.faces.push_back(face);
          kinds_of_faces.push_back(&type);
        }
      else if (type.dimension == 2 && type.n_corners > 0 && tag > 0)
        {
          const auto         corners = get_vertices(3);
          MshFile::OtherFace face;
          std::copy(corners.begin(), corners.end(), face.corners.begin());
          face.tag  = tag;
          face.kind = type.name;
          file.other_faces.push_back(face);
        }
      else if (type.dimension == 3)
        unusable.add(type);
    }



    void
    Reader::add_hexahedron(const std::size_t                number,
                           const MshElementType            &type,
                           const unsigned int               tag,
                           const std::vector<unsigned int> &of_gmsh)
    {
      dealii::CellData<dim> cell;
      for (unsigned int v = 0; v < 8; ++v)
        cell.vertices[v] = of_gmsh[gmsh_vertex[v]];
      cell.material_id = tag;
      file.cells.push_back(cell);
      file.numbers.push_back(number);
      ++n_hexahedra[type.n_nodes];
      if (of_gmsh.size() == 8)
        return;
      std::vector<dealii::Point<dim>> points;
      for (const unsigned int v : of_gmsh)
        points.push_back(nodes.points()[v]);
      file.complete = of_gmsh.size() == QuadraticCell::n_nodes;
      file.shapes.push_back(QuadraticCell::from_gmsh(points));
    }



    void
    Reader::check_elements() const
    {
      std::string kinds;
      for (const auto &[n_nodes, n] : n_hexahedra)
        kinds += (kinds.empty() ? "" : " beside ") + std::to_string(n) +
                 " hexahedra of " +
                 (n_nodes == 8 ? "eight" : std::to_string(n_nodes)) + " nodes";
      const std::string wrong = unusable.what_is_wrong(kinds);
      if (!wrong.empty())
        in.fail(wrong);
      if (n_hexahedra.size() > 1)
        in.fail(" has " + kinds +
                ", which do not fit together. Mesh all volumes with one "
                "'Mesh.ElementOrder' and one "
                "'Mesh.SecondOrderIncomplete'.");
      if (file.cells.empty())
        in.fail(" has no volume elements. Mesh the volumes (gmsh -3), and put "
                "each into a 'Physical Volume': Gmsh leaves out what is in no "
                "physical group. " +
                UnusableVolumes::how_to_mesh);
      if (!in.had_section("$PhysicalNames"))
        in.fail(
          " has no physical names, so nothing says what its cells are. Give "
          "every volume a name as in 'Physical Volume(\"wall\") = {1};'.");
    }



    void
    Reader::keep_used_vertices()
    {
      std::vector<unsigned int> new_number(
        nodes.points().size(), dealii::numbers::invalid_unsigned_int);
      std::vector<dealii::Point<dim>> used;
      for (auto &cell : file.cells)
        for (auto &v : cell.vertices)
          {
            if (new_number[v] == dealii::numbers::invalid_unsigned_int)
              {
                new_number[v] = used.size();
                used.push_back(nodes.points()[v]);
              }
            v = new_number[v];
          }
      file.vertices = std::move(used);

      // A surface without cells is no part of the body; its vertices have a
      // number no face of a cell has.
      for (auto &face : file.faces)
        {
          for (auto &v : face.vertices)
            v = new_number[v];
          std::sort(face.vertices.begin(), face.vertices.end());
        }
      for (auto &face : file.other_faces)
        for (auto &v : face.corners)
          v = new_number[v];
    }



    void
    Reader::sort_out_faces()
    {
      // By the nodes of a hexahedron, those of its faces.
      static const std::map<unsigned int, unsigned int> fitting = {
        {8, 4}, {27, 9}, {20, 8}};
      const unsigned int n_nodes =
        fitting.at(n_hexahedra.begin()->first);
      std::vector<MshFile::Face> fit;
      for (std::size_t i = 0; i < file.faces.size(); ++i)
        if (kinds_of_faces[i]->n_nodes == n_nodes)
          fit.push_back(file.faces[i]);
        else
          {
            MshFile::OtherFace other;
            std::copy_n(file.faces[i].vertices.begin(),
                        other.corners.size(),
                        other.corners.begin());
            other.tag  = file.faces[i].tag;
            other.kind = kinds_of_faces[i]->name;
            file.other_faces.push_back(other);
          }
      file.faces = fit;
    }



    MshFile
    Reader::result()
    {
      check_elements();
      sort_out_faces();
      keep_used_vertices();
      return std::move(file);
    }
  } // namespace



  MshFile
  read_msh_file(const std::string &parameter, const std::string &file_name)
  {
    MshLines lines(parameter, file_name);
    return Reader(lines).result();
  }
} // namespace lumbricus
