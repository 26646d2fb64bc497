// SPDX-License-Identifier: LGPL-2.1-or-later
#include "touching_parts.h"

#include <lumbricus/parameters/expression.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/tensor.h>
#include <deal.II/numerics/rtree.h>

#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

#include "mesh_faces.h"
#include "nearness.h"

namespace lumbricus
{
  namespace
  {
    using dealii::Point;
    using dealii::Tensor;
    using Box  = dealii::BoundingBox<dim>;
    using Tree = dealii::RTree<std::pair<Box, unsigned int>>;
    using Edge = std::pair<unsigned int, unsigned int>;

    // Of the shortest edge of the cells there.
    constexpr double touching = 1e-3;



    // The box around some points, wider by a length on all sides.
    template <typename Points>
    Box
    box_around(const Points &points, const double margin)
    {
      Point<dim> lower = points[0], upper = points[0];
      for (const Point<dim> &X : points)
        for (unsigned int d = 0; d < dim; ++d)
          {
            lower[d] = std::min(lower[d], X[d]);
            upper[d] = std::max(upper[d], X[d]);
          }
      for (unsigned int d = 0; d < dim; ++d)
        {
          lower[d] -= margin;
          upper[d] += margin;
        }
      return Box({lower, upper});
    }



    // The boundary of the cells, and what is looked for on it.
    class Surface
    {
    public:
      Surface(const std::vector<Point<dim>>            &vertices,
              const std::vector<dealii::CellData<dim>> &cells);

      std::string
      vertices_on_faces() const;

      std::string
      edges_that_cross() const;

      std::string
      vertices_in_cells() const;

      std::string
      bridged_edges() const;

    private:
      struct Face
      {
        std::array<unsigned int, 4> corners;
        unsigned int                cell;
      };

      // What was found, for the message.
      struct Places
      {
        std::size_t             n = 0;
        std::string             first;
        std::vector<Point<dim>> points = {};

        void
        add(const Point<dim>                   &X,
            const std::function<std::string()> &description)
        {
          if (n++ == 0)
            first = description();
          points.push_back(X);
        }
      };

      // That there are parts that @p what at these places.
      static std::string
      message(const Places &places, const std::string &what);

      std::string
      cell_at(const unsigned int c) const
      {
        return "the cell at " + point_text(centers[c]);
      }

      template <std::size_t n, typename Numbers>
      std::array<Point<dim>, n>
      points(const Numbers &numbers) const
      {
        std::array<Point<dim>, n> result;
        for (unsigned int i = 0; i < n; ++i)
          result[i] = vertices[numbers[i]];
        return result;
      }

      double
      distance(const Face &face, const unsigned int v) const;

      bool
      bridges(const Edge                &edge,
              std::vector<unsigned int> &path) const;

      const std::vector<Point<dim>>            &vertices;
      const std::vector<dealii::CellData<dim>> &cells;

      std::vector<Point<dim>> centers;
      /** The shortest edge, of a cell and of the cells at a vertex. */
      std::vector<double>                 size_of_cell, size_at_vertex;
      std::vector<FaceOfCell>             all_faces;
      std::vector<Face>                   faces;
      std::vector<unsigned int>           on_boundary;
      std::vector<Edge>                   edges;
      std::vector<double>                 size_of_edge;
      /** By vertex: those at the other ends of its edges. */
      std::vector<std::vector<unsigned int>> neighbours;
    };



    Surface::Surface(const std::vector<Point<dim>>            &vertices,
                     const std::vector<dealii::CellData<dim>> &cells)
      : vertices(vertices)
      , cells(cells)
      , size_at_vertex(vertices.size(), std::numeric_limits<double>::max())
      , all_faces(sorted_faces(cells))
      , neighbours(vertices.size())
    {
      for (const auto &cell : cells)
        {
          Point<dim> sum;
          double     shortest = std::numeric_limits<double>::max();
          for (unsigned int v = 0; v < 8; ++v)
            {
              sum += vertices[cell.vertices[v]];
              for (unsigned int d = 0; d < dim; ++d)
                shortest = std::min(shortest,
                                    vertices[cell.vertices[v]].distance(
                                      vertices[cell.vertices[v ^ (1u << d)]]));
            }
          centers.push_back(sum / 8.);
          size_of_cell.push_back(shortest);
          for (const unsigned int v : cell.vertices)
            size_at_vertex[v] = std::min(size_at_vertex[v], shortest);
        }

      std::map<Edge, double> sizes;
      for (std::size_t i = 0; i < all_faces.size(); ++i)
        {
          const bool inside =
            (i > 0 && all_faces[i].key == all_faces[i - 1].key) ||
            (i + 1 < all_faces.size() &&
             all_faces[i].key == all_faces[i + 1].key);
          if (inside)
            continue;
          Face face;
          face.cell = all_faces[i].cell;
          for (unsigned int v = 0; v < 4; ++v)
            face.corners[v] =
              cells[face.cell]
                .vertices[dealii::GeometryInfo<dim>::face_to_cell_vertices(
                  all_faces[i].face, v)];
          faces.push_back(face);
          for (const auto &[i, j] :
               {std::pair{0, 1}, {1, 3}, {3, 2}, {2, 0}})
            {
              const auto [a, b] =
                std::minmax(face.corners[i], face.corners[j]);
              const double size  = size_of_cell[face.cell];
              const auto   entry = sizes.insert({{a, b}, size});
              entry.first->second = std::min(entry.first->second, size);
              if (entry.second)
                {
                  neighbours[a].push_back(b);
                  neighbours[b].push_back(a);
                }
            }
        }
      for (const auto &[edge, size] : sizes)
        {
          edges.push_back(edge);
          size_of_edge.push_back(size);
        }
      for (unsigned int v = 0; v < vertices.size(); ++v)
        if (!neighbours[v].empty())
          on_boundary.push_back(v);
    }



    std::string
    Surface::message(const Places &places, const std::string &what)
    {
      if (places.n == 0)
        return "";
      const Box box = box_around(places.points, 0.);
      return " has parts that " + what + " at " +
             std::to_string(places.n) +
             (places.n == 1 ? " place: " : " places: ") + places.first +
             (places.n == 1 ?
                "" :
                "; all are between " +
                  point_text(box.get_boundary_points().first) + " and " +
                  point_text(box.get_boundary_points().second)) +
             ". Faces that touch have to be the same on both sides. " +
             how_to_join +
             " A finer mesh in a part of the body is the matter of 'Mesh' and "
             "'Adaptivity'.";
    }



    double
    Surface::distance(const Face &face, const unsigned int v) const
    {
      const auto corners = points<4>(face.corners);
      double     least   = distance_to_face(corners, vertices[v]);
      for (const auto &[i, j] : {std::pair{0, 1}, {1, 3}, {3, 2}, {2, 0}})
        least =
          std::min(least,
                   distance_to_edge(corners[i], corners[j], vertices[v]));
      return least;
    }



    std::string
    Surface::vertices_on_faces() const
    {
      std::vector<std::pair<Box, unsigned int>> boxes;
      for (unsigned int f = 0; f < faces.size(); ++f)
        boxes.emplace_back(box_around(points<4>(faces[f].corners),
                                      touching * size_of_cell[faces[f].cell]),
                           f);
      const Tree tree = dealii::pack_rtree(boxes);

      Places                                    places;
      std::vector<std::pair<Box, unsigned int>> near;
      for (const unsigned int v : on_boundary)
        {
          near.clear();
          tree.query(boost::geometry::index::intersects(vertices[v]),
                     std::back_inserter(near));
          for (const auto &[box, f] : near)
            {
              const Face &face = faces[f];
              if (std::find(face.corners.begin(), face.corners.end(), v) ==
                    face.corners.end() &&
                  distance(face, v) <
                    touching *
                      std::min(size_at_vertex[v], size_of_cell[face.cell]))
                {
                  places.add(vertices[v], [&]() {
                    return "the node " + point_text(vertices[v]) +
                           " lies on the face from " +
                           point_text(vertices[face.corners[0]]) + " to " +
                           point_text(vertices[face.corners[3]]) + " of " +
                           cell_at(face.cell) + ", which does not have it";
                  });
                  break;
                }
            }
        }
      return message(places, "touch and are not joined, with nodes in the "
                     "middle of other faces");
    }



    std::string
    Surface::edges_that_cross() const
    {
      std::vector<std::pair<Box, unsigned int>> boxes;
      for (unsigned int e = 0; e < edges.size(); ++e)
        boxes.emplace_back(
          box_around(std::array<Point<dim>, 2>{{vertices[edges[e].first],
                                                vertices[edges[e].second]}},
                     touching * size_of_edge[e]),
          e);
      const Tree tree = dealii::pack_rtree(boxes);

      Places                                    places;
      std::vector<std::pair<Box, unsigned int>> near;
      for (unsigned int e = 0; e < edges.size(); ++e)
        {
          const auto &[a, b] = edges[e];
          near.clear();
          tree.query(boost::geometry::index::intersects(boxes[e].first),
                     std::back_inserter(near));
          for (const auto &[box, other] : near)
            {
              const auto &[c, d] = edges[other];
              if (other <= e || a == c || a == d || b == c || b == d)
                continue;
              const auto [X, distance] = nearest_of_edges(
                vertices[a], vertices[b], vertices[c], vertices[d]);
              if (distance <
                  touching * std::min(size_of_edge[e], size_of_edge[other]))
                places.add(X, [&, X = X, c = c, d = d]() {
                  return "the edge from " +
                         point_text(vertices[edges[e].first]) + " to " + point_text(vertices[edges[e].second]) +
                         " crosses that from " + point_text(vertices[c]) +
                         " to " + point_text(vertices[d]) + " at " +
                         point_text(X);
                });
            }
        }
      return message(places, "touch and are not joined, with edges that cross");
    }



    std::string
    Surface::vertices_in_cells() const
    {
      std::vector<std::pair<Box, unsigned int>> boxes;
      for (unsigned int c = 0; c < cells.size(); ++c)
        boxes.emplace_back(box_around(points<8>(cells[c].vertices), 0.), c);
      const Tree tree = dealii::pack_rtree(boxes);

      Places                                    places;
      std::vector<std::pair<Box, unsigned int>> near;
      for (const unsigned int v : on_boundary)
        {
          near.clear();
          tree.query(boost::geometry::index::intersects(vertices[v]),
                     std::back_inserter(near));
          for (const auto &[box, c] : near)
            {
              const auto &corners = cells[c].vertices;
              if (std::find(corners.begin(), corners.end(), v) ==
                    corners.end() &&
                  is_inside(points<8>(corners), vertices[v], touching))
                {
                  places.add(vertices[v], [&, c = c]() {
                    return "the node " + point_text(vertices[v]) +
                           " is inside of " + cell_at(c);
                  });
                  break;
                }
            }
        }
      return message(places, "overlap and are not joined, with nodes inside of "
                     "other cells");
    }



    bool
    Surface::bridges(const Edge &edge, std::vector<unsigned int> &path) const
    {
      constexpr std::size_t most_vertices = 4;
      // The rise of an arc of 90 degrees is 0.207 of its chord.
      constexpr double     highest = 0.21;
      const Point<dim>    &A = vertices[edge.first], &B = vertices[edge.second];
      const Tensor<1, dim> AB = B - A;
      const auto           along = [&](const unsigned int v) {
        return (vertices[v] - A) * AB / (AB * AB);
      };
      for (const unsigned int v : neighbours[path.back()])
        {
          if (v == edge.second && path.size() > 1)
            {
              if (path.size() == 2)
                return true;
              // Four edges may be a flat face.
              FaceKey key = {{path[0], path[1], path[2], v}};
              std::sort(key.begin(), key.end());
              const auto found =
                std::lower_bound(all_faces.begin(),
                                 all_faces.end(),
                                 key,
                                 [](const FaceOfCell &face, const FaceKey &k) {
                                   return face.key < k;
                                 });
              if (found == all_faces.end() || found->key != key)
                return true;
            }
          const double t = along(v);
          if (path.size() + 1 < most_vertices && v != edge.second &&
              t > along(path.back()) + 0.1 && t < 0.9 &&
              vertices[v].distance(A + t * AB) < highest * AB.norm())
            {
              path.push_back(v);
              if (bridges(edge, path))
                return true;
              path.pop_back();
            }
        }
      return false;
    }



    std::string
    Surface::bridged_edges() const
    {
      Places places;
      for (const Edge &edge : edges)
        {
          std::vector<unsigned int> path = {edge.first};
          if (bridges(edge, path))
            places.add(vertices[path[1]], [&]() {
              return "the node " + point_text(vertices[path[1]]) +
                     " is beside the edge from " +
                     point_text(vertices[edge.first]) + " to " +
                     point_text(vertices[edge.second]) +
                     ", both ends of which it is joined to";
            });
        }
      return message(places, "touch and are not joined, with hanging nodes");
    }
  } // namespace



  const std::string how_to_join =
    "Make the volumes share their surfaces: in Gmsh by 'Coherence;' or "
    "'BooleanFragments' after all volumes, and before the physical groups.";



  std::string
  touching_parts(const std::vector<dealii::Point<dim>>    &vertices,
                 const std::vector<dealii::CellData<dim>> &cells)
  {
    const Surface surface(vertices, cells);
    for (const auto look : {&Surface::vertices_on_faces,
                            &Surface::edges_that_cross,
                            &Surface::vertices_in_cells,
                            &Surface::bridged_edges})
      {
        const std::string found = (surface.*look)();
        if (!found.empty())
          return found;
      }
    return "";
  }
} // namespace lumbricus
