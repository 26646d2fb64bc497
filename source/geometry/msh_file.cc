// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/geometry/msh_file.h>
#include <lumbricus/geometry/msh_lines.h>

#include <deal.II/base/types.h>
#include <deal.II/base/utilities.h>

#include <cmath>
#include <cstdlib>
#include <utility>

namespace lumbricus
{
  namespace
  {
    // Gmsh's numbers of element types.
    constexpr unsigned int quadrilateral = 3;
    constexpr unsigned int hexahedron    = 5;

    const std::map<unsigned int, std::string> unusable_volumes = {
      {4, "tetrahedra"},
      {6, "prisms"},
      {7, "pyramids"},
      {11, "tetrahedra of second order"},
      {12, "hexahedra of second order"},
      {13, "prisms of second order"},
      {14, "pyramids of second order"},
      {17, "hexahedra of second order"},
      {18, "prisms of second order"},
      {19, "pyramids of second order"},
      {29, "tetrahedra of third order"},
      {92, "hexahedra of third order"},
      {93, "hexahedra of fourth order"}};

    const std::string how_to_mesh =
      "Mesh with hexahedra: in Gmsh by 'Transfinite' and 'Recombine' "
      "('Mesh.RecombineAll = 1;'), by 'Extrude' with 'Recombine', or from "
      "tetrahedra by 'Mesh.SubdivisionAlgorithm = 2;'.";

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
        return std::abs(in.get<int>());
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
      read_nodes();

      void
      add_node(const std::size_t node);

      void
      read_elements();

      void
      add_element(const unsigned int type, const unsigned int tag);

      void
      check_elements() const;

      void
      keep_used_vertices();

      MshLines &in;
      bool      version4 = false;

      MshFile file;
      bool    has_names = false;
      /** By dimension and number of an entity. */
      std::map<std::pair<int, int>, unsigned int> tags;
      std::map<std::size_t, unsigned int>         vertex_of_node;
      std::map<std::string, std::size_t>          n_unusable;
    };



    void
    Reader::check_format()
    {
      if (!in.next() || in.trimmed() != "$MeshFormat")
        in.fail(
          " is not a file of Gmsh: it does not begin with '$MeshFormat'. " +
          MshLines::how_to_write);
      in.need();
      const auto version = in.get<double>();
      version4           = std::abs(version - 4.1) < 1e-6;
      if (!version4 && !(version > 1.9 && version < 2.9))
        in.fail(" has Gmsh's format " + in.first_word() +
                "; the formats 2.2 and 4.1 can be read. " +
                MshLines::how_to_write);
      if (in.get<int>() != 0)
        in.fail(" is binary; text can be read. " + MshLines::how_to_write);
      in.need();
    }



    void
    Reader::read_section(const std::string &name)
    {
      if (name == "$PhysicalNames")
        read_names();
      else if (name == "$Entities")
        read_entities();
      else if (name == "$Nodes")
        read_nodes();
      else if (name == "$Elements")
        read_elements();
      else if (name == "$PartitionedEntities")
        in.fail(
          " has been partitioned. Write it without partitions: the program "
          "makes its own.");
      else if (name.empty() || name[0] != '$')
        in.fail_in_line("'" + name + "', is not the begin of a section. " +
                        MshLines::how_to_write);

      const std::string end = "$End" + name.substr(1);
      while (in.trimmed() != end)
        in.need();
    }



    void
    Reader::read_names()
    {
      in.need();
      for (std::size_t n = in.get_count(); n > 0; --n)
        {
          in.need();
          const auto        dimension = in.get<int>();
          const auto        tag       = get_tag();
          const std::string line      = in.trimmed();
          const auto        first = line.find('"'), last = line.rfind('"');
          if (first == last)
            in.fail_in_line("has no name in quotation marks. " +
                            MshLines::how_to_write);
          const std::string name =
            dealii::Utilities::trim(line.substr(first + 1, last - first - 1));
          if (dimension == 3)
            file.volume_names[tag] = name;
          else if (dimension == 2)
            file.surface_names[tag] = name;
        }
      has_names = true;
    }



    void
    Reader::read_entities()
    {
      in.need();
      std::array<std::size_t, 4> n_entities;
      for (std::size_t &n : n_entities)
        n = in.get_count();
      for (unsigned int d = 0; d < n_entities.size(); ++d)
        for (std::size_t n = n_entities[d]; n > 0; --n)
          {
            in.need();
            const auto entity = in.get<int>();
            // A point, or the corners of a box.
            for (unsigned int i = 0; i < (d == 0 ? 3 : 6); ++i)
              in.get<double>();
            const std::size_t n_tags = in.get_count();
            if (n_tags > 1 && d >= 2)
              in.fail_in_line(
                (d == 2 ? "has a surface" : "has a volume") +
                std::string(" in two physical groups. Put it into "
                            "one."));
            if (n_tags == 1)
              tags[{d, entity}] = get_tag();
          }
    }



    void
    Reader::read_nodes()
    {
      in.need();
      if (!version4)
        {
          for (std::size_t n = in.get_count(); n > 0; --n)
            {
              in.need();
              add_node(in.get_count());
            }
          return;
        }
      for (std::size_t n_blocks = in.get_count(); n_blocks > 0; --n_blocks)
        {
          in.need();
          for (unsigned int i = 0; i < 3; ++i)
            in.get<int>();
          std::vector<std::size_t> nodes;
          for (std::size_t n = in.get_count(); n > 0; --n)
            {
              in.need();
              nodes.push_back(in.get_count());
            }
          for (const std::size_t node : nodes)
            {
              in.need();
              add_node(node);
            }
        }
    }



    void
    Reader::add_node(const std::size_t node)
    {
      dealii::Point<dim> X;
      for (unsigned int d = 0; d < dim; ++d)
        X[d] = in.get<double>();
      vertex_of_node[node] = file.vertices.size();
      file.vertices.push_back(X);
    }



    void
    Reader::read_elements()
    {
      in.need();
      if (!version4)
        {
          for (std::size_t n = in.get_count(); n > 0; --n)
            {
              in.need();
              in.get_count();
              const auto   type = in.get<unsigned int>();
              unsigned int tag  = 0;
              for (std::size_t i = 0, n_tags = in.get_count(); i < n_tags; ++i)
                {
                  const unsigned int other = get_tag();
                  tag                      = i == 0 ? other : tag;
                }
              add_element(type, tag);
            }
          return;
        }
      for (std::size_t n_blocks = in.get_count(); n_blocks > 0; --n_blocks)
        {
          in.need();
          const auto dimension = in.get<int>();
          const auto entity    = in.get<int>();
          const auto type      = in.get<unsigned int>();
          const auto found     = tags.find({dimension, entity});
          const auto tag       = found == tags.end() ? 0 : found->second;
          for (std::size_t n = in.get_count(); n > 0; --n)
            {
              in.need();
              in.get_count();
              add_element(type, tag);
            }
        }
    }



    void
    Reader::add_element(const unsigned int type, const unsigned int tag)
    {
      const auto vertex = [&]() {
        const auto found = vertex_of_node.find(in.get_count());
        if (found == vertex_of_node.end())
          in.fail_in_line(
            "names a node the file does not have. Write it again.");
        return found->second;
      };

      if (type == hexahedron)
        {
          std::array<unsigned int, 8> of_gmsh;
          for (unsigned int &v : of_gmsh)
            v = vertex();
          dealii::CellData<dim> cell;
          for (unsigned int v = 0; v < 8; ++v)
            cell.vertices[v] = of_gmsh[gmsh_vertex[v]];
          cell.material_id = tag;
          file.cells.push_back(cell);
        }
      else if (type == quadrilateral && tag > 0)
        {
          MshFile::Face face;
          for (unsigned int &v : face.vertices)
            v = vertex();
          std::sort(face.vertices.begin(), face.vertices.end());
          face.tag = tag;
          file.faces.push_back(face);
        }
      else if (unusable_volumes.count(type) > 0)
        ++n_unusable[unusable_volumes.at(type)];
    }



    void
    Reader::check_elements() const
    {
      for (const auto &[what, n] : n_unusable)
        if (what.find("order") == std::string::npos)
          in.fail(" has " + std::to_string(n) + " " + what +
                  "; only hexahedra can be used. " + how_to_mesh);
        else
          in.fail(
            " has " + std::to_string(n) + " " + what +
            "; only hexahedra of eight nodes can be used. Set "
            "'Mesh.ElementOrder = 1;'. Round surfaces become round by the "
            "parameter 'Round surfaces'.");
      if (file.cells.empty())
        in.fail(" has no volume elements. Mesh the volumes (gmsh -3), and put "
                "each into a 'Physical Volume': Gmsh leaves out what is in no "
                "physical group. " +
                how_to_mesh);
      if (!has_names)
        in.fail(
          " has no physical names, so nothing says what its cells are. Give "
          "every volume a name as in 'Physical Volume(\"wall\") = {1};'.");
    }



    void
    Reader::keep_used_vertices()
    {
      std::vector<unsigned int> new_number(
        file.vertices.size(), dealii::numbers::invalid_unsigned_int);
      std::vector<dealii::Point<dim>> used;
      for (auto &cell : file.cells)
        for (auto &v : cell.vertices)
          {
            if (new_number[v] == dealii::numbers::invalid_unsigned_int)
              {
                new_number[v] = used.size();
                used.push_back(file.vertices[v]);
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
    }



    MshFile
    Reader::result()
    {
      check_elements();
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
