// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/geometry/msh_file.h>

#include <deal.II/base/utilities.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
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

    const std::string how_to_write =
      "Write it with 'Mesh.MshFileVersion = 4.1;' and 'Mesh.Binary = 0;'.";
    const std::string how_to_mesh =
      "Mesh with hexahedra: in Gmsh by 'Transfinite' and 'Recombine' "
      "('Mesh.RecombineAll = 1;'), by 'Extrude' with 'Recombine', or from "
      "tetrahedra by 'Mesh.SubdivisionAlgorithm = 2;'.";

    // From deal.II's number of a vertex of a hexahedron to Gmsh's.
    constexpr std::array<unsigned int, 8> gmsh_vertex = {
      {0, 1, 3, 2, 4, 5, 7, 6}};



    // Reads a file line by line, sections first.
    class Reader
    {
    public:
      Reader(const std::string &parameter, const std::string &file_name)
        : in(file_name)
        , begin("Parameter '" + parameter + "': the mesh file '" + file_name +
                "'")
      {
        AssertThrow(in && !std::filesystem::is_directory(file_name),
                    ExcInput(begin +
                             " cannot be read. Give the path of a .msh file of "
                             "Gmsh, from the working directory."));
        // Nothing in a section of a binary file is a line.
        check_format();
        while (next_line())
          read_section(dealii::Utilities::trim(line));
      }

      MshFile
      result();

    private:
      [[noreturn]] void
      fail(const std::string &what) const
      {
        throw ExcInput(begin + what);
      }

      [[noreturn]] void
      fail_in_line(const std::string &what) const
      {
        fail(", line " + std::to_string(number) + ", " + what);
      }

      // The next line that is not blank, if there is one.
      bool
      next_line()
      {
        while (std::getline(in, line))
          {
            ++number;
            if (line.find_first_not_of(" \t\r") != std::string::npos)
              {
                words.clear();
                words.str(line);
                return true;
              }
          }
        return false;
      }

      void
      need_line()
      {
        if (!next_line())
          fail(" ends too early, in line " + std::to_string(number) +
               ". Write it again.");
      }

      // The next number in the line.
      template <typename T>
      T
      get()
      {
        T value;
        if (!(words >> value))
          fail_in_line("'" + dealii::Utilities::trim(line) +
                       "', has no number where one belongs. " + how_to_write);
        return value;
      }

      // A number of things or of a node.
      std::size_t
      get_count()
      {
        const auto value = get<long long>();
        if (value < 0)
          fail_in_line("has a number < 0 where none belongs. " + how_to_write);
        return value;
      }

      // Tags are negative where a surface is turned around.
      unsigned int
      get_tag()
      {
        return std::abs(get<int>());
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

      std::ifstream      in;
      const std::string  begin;
      std::string        line;
      std::istringstream words;
      std::size_t        number   = 0;
      bool               version4 = false;

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
      if (!next_line() || line.compare(0, 11, "$MeshFormat") != 0)
        fail(" is not a file of Gmsh: it does not begin with '$MeshFormat'. " +
             how_to_write);
      need_line();
      const auto version = get<double>();
      version4           = std::abs(version - 4.1) < 1e-6;
      if (!version4 && !(version > 1.9 && version < 2.9))
        fail(" has Gmsh's format " +
             dealii::Utilities::trim(line.substr(0, line.find(' '))) +
             "; the formats 2.2 and 4.1 can be read. " + how_to_write);
      if (get<int>() != 0)
        fail(" is binary; text can be read. " + how_to_write);
      need_line();
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
        fail(" has been partitioned. Write it without partitions: the program "
             "makes its own.");
      else if (name.empty() || name[0] != '$')
        fail_in_line("'" + name + "', is not the begin of a section. " +
                     how_to_write);

      const std::string end = "$End" + name.substr(1);
      while (dealii::Utilities::trim(line) != end)
        need_line();
    }



    void
    Reader::read_names()
    {
      need_line();
      for (std::size_t n = get_count(); n > 0; --n)
        {
          need_line();
          const auto dimension = get<int>();
          const auto tag       = get_tag();
          const auto first = line.find('"'), last = line.rfind('"');
          if (first == last)
            fail_in_line("has no name in quotation marks.");
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
      need_line();
      std::array<std::size_t, 4> n_entities;
      for (std::size_t &n : n_entities)
        n = get_count();
      for (unsigned int d = 0; d < n_entities.size(); ++d)
        for (std::size_t n = n_entities[d]; n > 0; --n)
          {
            need_line();
            const auto entity = get<int>();
            // A point, or the corners of a box.
            for (unsigned int i = 0; i < (d == 0 ? 3 : 6); ++i)
              get<double>();
            const std::size_t n_tags = get_count();
            if (n_tags > 1 && d >= 2)
              fail_in_line((d == 2 ? "has a surface" : "has a volume") +
                           std::string(" in two physical groups. Put it into "
                                       "one."));
            if (n_tags == 1)
              tags[{d, entity}] = get_tag();
          }
    }



    void
    Reader::read_nodes()
    {
      need_line();
      if (!version4)
        {
          for (std::size_t n = get_count(); n > 0; --n)
            {
              need_line();
              add_node(get_count());
            }
          return;
        }
      for (std::size_t n_blocks = get_count(); n_blocks > 0; --n_blocks)
        {
          need_line();
          for (unsigned int i = 0; i < 3; ++i)
            get<int>();
          std::vector<std::size_t> nodes(get_count());
          for (std::size_t &node : nodes)
            {
              need_line();
              node = get_count();
            }
          for (const std::size_t node : nodes)
            {
              need_line();
              add_node(node);
            }
        }
    }



    void
    Reader::add_node(const std::size_t node)
    {
      dealii::Point<dim> X;
      for (unsigned int d = 0; d < dim; ++d)
        X[d] = get<double>();
      vertex_of_node[node] = file.vertices.size();
      file.vertices.push_back(X);
    }



    void
    Reader::read_elements()
    {
      need_line();
      if (!version4)
        {
          for (std::size_t n = get_count(); n > 0; --n)
            {
              need_line();
              get_count();
              const auto   type = get<unsigned int>();
              unsigned int tag  = 0;
              for (std::size_t i = 0, n_tags = get_count(); i < n_tags; ++i)
                {
                  const unsigned int other = get_tag();
                  tag                      = i == 0 ? other : tag;
                }
              add_element(type, tag);
            }
          return;
        }
      for (std::size_t n_blocks = get_count(); n_blocks > 0; --n_blocks)
        {
          need_line();
          const auto dimension = get<int>();
          const auto entity    = get<int>();
          const auto type      = get<unsigned int>();
          const auto found     = tags.find({dimension, entity});
          const auto tag       = found == tags.end() ? 0 : found->second;
          for (std::size_t n = get_count(); n > 0; --n)
            {
              need_line();
              get_count();
              add_element(type, tag);
            }
        }
    }



    void
    Reader::add_element(const unsigned int type, const unsigned int tag)
    {
      const auto vertex = [&]() {
        const auto found = vertex_of_node.find(get_count());
        if (found == vertex_of_node.end())
          fail_in_line("names a node the file does not have. Write it again.");
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



    MshFile
    Reader::result()
    {
      for (const auto &[what, n] : n_unusable)
        if (what.find("order") == std::string::npos)
          fail(" has " + std::to_string(n) + " " + what +
               "; only hexahedra can be used. " + how_to_mesh);
        else
          fail(" has " + std::to_string(n) + " " + what +
               "; only hexahedra of eight nodes can be used. Set "
               "'Mesh.ElementOrder = 1;'. Round surfaces become round by the "
               "parameter 'Round surfaces'.");
      if (file.cells.empty())
        fail(" has no volume elements. Mesh the volumes (gmsh -3), and put "
             "each into a 'Physical Volume': Gmsh leaves out what is in no "
             "physical group. " +
             how_to_mesh);
      if (!has_names)
        fail(" has no physical names, so nothing says what its cells are. Give "
             "every volume a name as in 'Physical Volume(\"wall\") = {1};'.");

      // Keep the vertices of cells only.
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
      return std::move(file);
    }
  } // namespace



  MshFile
  read_msh_file(const std::string &parameter, const std::string &file_name)
  {
    return Reader(parameter, file_name).result();
  }
} // namespace lumbricus
