// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh_checks.h"

#include <lumbricus/parameters/expression.h>

#include <deal.II/base/tensor.h>

#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "mesh_faces.h"
#include "touching_parts.h"

namespace lumbricus
{
  namespace
  {
    using Vertices = std::vector<dealii::Point<dim>>;
    using Cells    = std::vector<dealii::CellData<dim>>;

    dealii::Point<dim>
    center(const Vertices &vertices, const dealii::CellData<dim> &cell)
    {
      dealii::Point<dim> sum;
      for (const unsigned int v : cell.vertices)
        sum += vertices[v];
      return sum / 8.;
    }



    // Whether the edges at one of its corners do not span a volume > 0.
    bool
    is_folded(const Vertices &vertices, const dealii::CellData<dim> &cell)
    {
      for (unsigned int v = 0; v < 8; ++v)
        {
          std::array<dealii::Tensor<1, dim>, dim> edges;
          double                                  scale = 1.;
          for (unsigned int d = 0; d < dim; ++d)
            {
              const unsigned int bit = 1u << d;
              edges[d]               = vertices[cell.vertices[v | bit]] -
                         vertices[cell.vertices[v & ~bit]];
              scale *= edges[d].norm();
            }
          if (!(edges[0] * cross_product_3d(edges[1], edges[2]) > 1e-6 * scale))
            return true;
        }
      return false;
    }



    std::string
    folded_cells(const Vertices &vertices, const Cells &cells)
    {
      std::size_t                  n     = 0;
      const dealii::CellData<dim> *first = nullptr;
      for (const auto &cell : cells)
        if (is_folded(vertices, cell))
          {
            ++n;
            first = first == nullptr ? &cell : first;
          }
      if (n == 0)
        return "";
      return " has " + std::to_string(n) +
             " cells that are folded or flat; the first has its centre at " +
             point_text(center(vertices, *first)) +
             ". Mesh that place with better shaped cells.";
    }



    std::string
    faces_of_many_cells(const Vertices &vertices, const Cells &cells)
    {
      const auto faces = sorted_faces(cells);
      for (std::size_t i = 2; i < faces.size(); ++i)
        if (faces[i].key == faces[i - 2].key)
          return " has more than two cells at one face, of the cell at " +
                 point_text(center(vertices, cells[faces[i].cell])) +
                 ". Put every volume into one physical group only, and see "
                 "that no volumes overlap.";
      return "";
    }



    std::string
    cells_twice(const Vertices &vertices, const Cells &cells)
    {
      std::map<std::array<unsigned int, 8>, unsigned int> known;
      for (const auto &cell : cells)
        {
          std::array<unsigned int, 8> key;
          std::copy(cell.vertices.begin(), cell.vertices.end(), key.begin());
          std::sort(key.begin(), key.end());
          if (++known[key] > 1)
            return " has the cell at " + point_text(center(vertices, cell)) +
                   " twice. Put every volume into one physical group only.";
        }
      return "";
    }



    double
    shortest_edge(const Vertices &vertices, const Cells &cells)
    {
      double shortest = std::numeric_limits<double>::max();
      for (const auto &cell : cells)
        for (unsigned int v = 0; v < 8; ++v)
          for (unsigned int d = 0; d < dim; ++d)
            if ((v & (1u << d)) == 0)
              shortest = std::min(shortest,
                                  vertices[cell.vertices[v]].distance(
                                    vertices[cell.vertices[v | (1u << d)]]));
      return shortest;
    }



    std::string
    double_vertices(const Vertices &vertices, const Cells &cells)
    {
      // Along a direction in which few vertices of a regular mesh coincide.
      const dealii::Point<dim>  direction(0.538, 0.314, 0.782);
      std::vector<double>       s;
      std::vector<unsigned int> order(vertices.size());
      for (const auto &X : vertices)
        s.push_back(X * direction);
      std::iota(order.begin(), order.end(), 0u);
      std::sort(order.begin(), order.end(), [&](const auto a, const auto b) {
        return s[a] < s[b];
      });

      const double tolerance = 1e-3 * shortest_edge(vertices, cells);
      for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t j = i + 1;
             j < order.size() && s[order[j]] - s[order[i]] < tolerance;
             ++j)
          if (vertices[order[i]].distance(vertices[order[j]]) < tolerance)
            return " has two nodes at the same place, " +
                   point_text(vertices[order[i]]) +
                   ", so that what touches there is not joined. " + how_to_join;
      return "";
    }



    // For every cell the number of a cell of its part; those that share a face
    // are in one part.
    std::vector<unsigned int>
    parts_of_cells(const Cells &cells)
    {
      std::vector<unsigned int> parent(cells.size());
      std::iota(parent.begin(), parent.end(), 0u);
      const auto root = [&](unsigned int c) {
        while (parent[c] != c)
          c = parent[c] = parent[parent[c]];
        return c;
      };
      const auto faces = sorted_faces(cells);
      for (std::size_t i = 1; i < faces.size(); ++i)
        if (faces[i].key == faces[i - 1].key)
          parent[root(faces[i].cell)] = root(faces[i - 1].cell);
      std::vector<unsigned int> parts;
      for (unsigned int c = 0; c < cells.size(); ++c)
        parts.push_back(root(c));
      return parts;
    }



    std::string
    loose_parts(const Vertices &vertices, const Cells &cells)
    {
      const auto                   part = parts_of_cells(cells);
      const std::set<unsigned int> parts(part.begin(), part.end());
      if (parts.size() == 1)
        return "";
      const std::string n = std::to_string(parts.size());

      // Two cells at a vertex, of different parts.
      std::vector<unsigned int> cell_at(vertices.size(), cells.size());
      for (unsigned int c = 0; c < cells.size(); ++c)
        for (const unsigned int v : cells[c].vertices)
          if (cell_at[v] == cells.size())
            cell_at[v] = c;
          else if (part[cell_at[v]] != part[c])
            return " has " + n +
                   " parts that share edges or nodes, but no faces, as the "
                   "cells at " +
                   point_text(center(vertices, cells[cell_at[v]])) + " and " +
                   point_text(center(vertices, cells[c])) + " do at " +
                   point_text(vertices[v]) +
                   ", so that they are not joined. " + how_to_join;

      unsigned int other = 0;
      while (part[other] == part[0])
        ++other;
      return " has " + n + " parts that are not joined: the cells at " +
             point_text(center(vertices, cells[0])) + " and " +
             point_text(center(vertices, cells[other])) +
             " are in different ones. " + how_to_join;
    }
  } // namespace



  std::string
  what_is_wrong(const Vertices &vertices, const Cells &cells)
  {
    for (const auto &check :
         {folded_cells,
          faces_of_many_cells,
          cells_twice,
          double_vertices,
          touching_parts,
          loose_parts})
      {
        const std::string message = check(vertices, cells);
        if (!message.empty())
          return message;
      }
    return "";
  }
} // namespace lumbricus
