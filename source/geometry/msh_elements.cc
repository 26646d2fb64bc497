// SPDX-License-Identifier: LGPL-2.1-or-later

#include "msh_elements.h"

#include <vector>

namespace lumbricus
{
  namespace
  {
    struct Family
    {
      MshElementType type;
      /** Gmsh's numbers, as in its GmshDefines.h. */
      std::vector<int> numbers;
    };



    const std::vector<Family> &
    families()
    {
      static const std::vector<Family> all = {
        {{0, 0, "points"}, {15, 133}},
        {{1, 0, "lines"},
         {1, 8, 26, 27, 28, 62, 63, 64, 65, 66, 67, 70, 84, 134}},
        {{2, 3, "triangles"}, {2}},
        {{2, 3, "triangles of second order"}, {9}},
        {{2, 3, "triangles of higher order"},
         {20, 21, 22, 23, 24, 25, 42, 43, 44, 45, 46,  52, 53,
          54, 55, 56, 68, 85, 135, 138}},
        {{2, 4, "quadrilaterals", 4}, {MshElementType::quadrilateral}},
        {{2, 4, "quadrilaterals of nine nodes", 9},
         {MshElementType::quadrilateral_9}},
        {{2, 4, "quadrilaterals of eight nodes", 8},
         {MshElementType::quadrilateral_8}},
        {{2, 4, "quadrilaterals of higher order"},
         {36, 37, 38, 39, 40, 41, 47, 48, 49, 50, 51, 57, 58, 59, 60, 61, 86}},
        {{2, 0, "polygons"}, {34, 69}},
        {{3, 4, "tetrahedra"}, {4}},
        {{3, 4, "tetrahedra of second order"}, {11}},
        {{3, 4, "tetrahedra of third order"}, {29}},
        {{3, 4, "tetrahedra of higher order"},
         {30, 31, 32, 33, 71, 72, 73, 74, 75, 79, 80,
          81, 82, 83, 87, 136, 137, 139}},
        {{3, 8, "hexahedra", 8}, {MshElementType::hexahedron}},
        {{3, 8, "hexahedra of 27 nodes", 27}, {MshElementType::hexahedron_27}},
        {{3, 8, "hexahedra of 20 nodes", 20}, {MshElementType::hexahedron_20}},
        {{3, 8, "hexahedra of third order"}, {92}},
        {{3, 8, "hexahedra of fourth order"}, {93}},
        {{3, 8, "hexahedra of higher order"},
         {88, 94, 95, 96, 97, 98, 99, 100, 101, 102, 103, 104, 105}},
        {{3, 6, "prisms"}, {6}},
        {{3, 6, "prisms of second order"}, {13, 18}},
        {{3, 6, "prisms of higher order"},
         {89, 90, 91, 106, 107, 108, 109, 110, 111, 112, 113, 114, 115, 116,
          117}},
        {{3, 5, "pyramids"}, {7}},
        {{3, 5, "pyramids of second order"}, {14, 19}},
        {{3, 5, "pyramids of higher order"},
         {118, 119, 120, 121, 122, 123, 124, 125, 126, 127, 128, 129, 130, 131,
          132}},
        {{3, 0, "polyhedra"}, {35}},
        {{3, 4, "trihedra"}, {140}}};
      return all;
    }
  } // namespace



  const MshElementType *
  MshElementType::find(const int type)
  {
    static const auto by_number = []() {
      std::map<int, const MshElementType *> types;
      for (const Family &family : families())
        for (const int number : family.numbers)
          types[number] = &family.type;
      return types;
    }();
    const auto found = by_number.find(type);
    return found == by_number.end() ? nullptr : found->second;
  }



  const std::string UnusableVolumes::how_to_mesh =
    "Mesh with hexahedra: in Gmsh by 'Transfinite' and 'Recombine' "
    "('Mesh.RecombineAll = 1;'), by 'Extrude' with 'Recombine', or from "
    "tetrahedra by 'Mesh.SubdivisionAlgorithm = 2;'.";



  void
  UnusableVolumes::add(const MshElementType &type)
  {
    ++n[type.name];
  }



  std::string
  UnusableVolumes::what_is_wrong(const std::string &hexahedra) const
  {
    if (n.empty())
      return "";
    std::string all;
    bool        linear = false;
    for (const auto &[name, number] : n)
      {
        all += (all.empty() ? "" : ", ") + std::to_string(number) + " " + name;
        linear = linear || name.find("order") == std::string::npos;
      }
    if (!hexahedra.empty())
      all += " beside " + hexahedra;
    return " has " + all + "; only hexahedra can be used" +
           (linear ? ". " + how_to_mesh :
                     " (of first or second order). Set 'Mesh.ElementOrder' to "
                     "1 or 2. " +
                       how_to_mesh);
  }
} // namespace lumbricus
