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
        {{2, 4, "quadrilaterals"}, {MshElementType::quadrilateral}},
        {{2, 4, "quadrilaterals of second order"}, {10, 16}},
        {{2, 4, "quadrilaterals of higher order"},
         {36, 37, 38, 39, 40, 41, 47, 48, 49, 50, 51, 57, 58, 59, 60, 61, 86}},
        {{2, 0, "polygons"}, {34, 69}},
        {{3, 4, "tetrahedra"}, {4}},
        {{3, 4, "tetrahedra of second order"}, {11}},
        {{3, 4, "tetrahedra of third order"}, {29}},
        {{3, 4, "tetrahedra of higher order"},
         {30, 31, 32, 33, 71, 72, 73, 74, 75, 79, 80,
          81, 82, 83, 87, 136, 137, 139}},
        {{3, 8, "hexahedra"}, {MshElementType::hexahedron}},
        {{3, 8, "hexahedra of second order"}, {12, 17}},
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
  UnusableVolumes::what_is_wrong(const std::size_t n_hexahedra) const
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
    if (n_hexahedra > 0)
      all += " beside " + std::to_string(n_hexahedra) +
             " hexahedra of eight nodes";
    return " has " + all +
           (linear ? "; only hexahedra can be used. " + how_to_mesh :
                     "; only hexahedra of eight nodes can be used. Set "
                     "'Mesh.ElementOrder = 1;'. Round surfaces become round by "
                     "the parameter 'Round surfaces'.");
  }
} // namespace lumbricus
