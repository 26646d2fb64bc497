// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_msh_elements_h
#define lumbricus_geometry_msh_elements_h

#include <map>
#include <string>

namespace lumbricus
{
  /** A type of element as Gmsh numbers them. */
  struct MshElementType
  {
    /** Of a quadrilateral of four nodes. */
    static constexpr int quadrilateral = 3;
    /** Of a quadrilateral of nine nodes. */
    static constexpr int quadrilateral_9 = 10;
    /** Of a quadrilateral of eight nodes. */
    static constexpr int quadrilateral_8 = 16;
    /** Of a hexahedron of eight nodes. */
    static constexpr int hexahedron = 5;
    /** Of a hexahedron of 27 nodes. */
    static constexpr int hexahedron_27 = 12;
    /** Of a hexahedron of 20 nodes. */
    static constexpr int hexahedron_20 = 17;

    /** From 0, a point, to 3, a volume. */
    int dimension;
    /** How many nodes are corners; zero where the type has none. */
    unsigned int n_corners;
    /** In the plural. */
    std::string name;
    /** How many nodes it has, where the program can use the type; else zero. */
    unsigned int n_nodes = 0;

    /** That of number @p type, or nullptr where Gmsh has none. */
    static const MshElementType *
    find(const int type);
  };



  /** How many volume elements of which kind there are that cannot be used. */
  class UnusableVolumes
  {
  public:
    /** One more of a type of dimension 3. */
    void
    add(const MshElementType &type);

    /** What is wrong with a file that has @p hexahedra besides, and what to do, as
     * the end of a sentence about the file; empty if there are none. */
    std::string
    what_is_wrong(const std::string &hexahedra) const;

    /** How to get hexahedra from Gmsh, for messages. */
    static const std::string how_to_mesh;

  private:
    std::map<std::string, std::size_t> n;
  };
} // namespace lumbricus

#endif
