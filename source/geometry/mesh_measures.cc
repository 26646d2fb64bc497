// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh_measures.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <tuple>

#include "mesh_faces.h"

namespace lumbricus
{
  namespace
  {
    using Vertices = std::vector<dealii::Point<dim>>;
    using Cells    = std::vector<dealii::CellData<dim>>;

    // Where something begins and ends along x.
    struct Extent1d
    {
      double begin = std::numeric_limits<double>::max();
      double end   = -std::numeric_limits<double>::max();

      void
      include(const double x)
      {
        begin = std::min(begin, x);
        end   = std::max(end, x);
      }

      bool
      empty() const
      {
        return begin > end;
      }
    };



    // What the sections of a segment follow from.
    struct Along
    {
      Extent1d all, liquid;
      /** Where mesh faces lie in a plane x = const. */
      std::set<double> wall_planes, middle_planes;
    };



    // The plane nearest to x, if it is near enough; else x.
    double
    nearest_plane(const std::set<double> &planes,
                  const double            x,
                  const double            distance)
    {
      double nearest = x, smallest = distance * (1. + 1e-9);
      for (const double plane : planes)
        if (std::abs(plane - x) < smallest)
          {
            smallest = std::abs(plane - x);
            nearest  = plane;
          }
      return nearest;
    }



    // The mean x of a face, or NaN where it is not in a plane x = const. The shape
    // of a curved cell is @p curved.
    double
    plane_of_face(const Vertices              &vertices,
                  const dealii::CellData<dim> &cell,
                  const CurvedCell            *curved,
                  const unsigned int           f,
                  const double                 tolerance)
    {
      Extent1d      extent;
      double        mean = 0.;
      const FaceKey key  = face_key(cell, f);
      for (const unsigned int v : key)
        {
          extent.include(vertices[v][0]);
          mean += vertices[v][0] / 4;
        }
      if (curved != nullptr)
        for (const dealii::Point<dim> &X : curved->face_nodes(key))
          extent.include(X[0]);
      return extent.end - extent.begin < tolerance ?
               mean :
               std::numeric_limits<double>::quiet_NaN();
    }
  } // namespace



  std::vector<SegmentSections>
  mesh_sections(const Vertices                &vertices,
                const Cells                   &cells,
                const std::vector<TissueName> &tissues,
                const unsigned int             n_segments,
                const std::vector<CavityWall> &cavities,
                const std::map<FaceKey, dealii::types::boundary_id>
                                              &boundary_ids,
                const std::vector<CurvedCell> &curved_cells)
  {
    Extent1d body;
    for (const auto &X : vertices)
      body.include(X[0]);
    const double tolerance = 1e-9 * (body.end - body.begin);
    const bool   has_liquid =
      std::any_of(tissues.begin(), tissues.end(), [](const auto &tissue) {
        return tissue.liquid;
      });

    std::vector<Along> segments(n_segments);
    for (std::size_t c = 0; c < cells.size(); ++c)
      {
        const auto       &cell    = cells[c];
        const Region      region  = Region::of(cell.material_id);
        const TissueName &tissue  = tissues[region.tissue];
        Along            &segment = segments[region.segment];
        for (const unsigned int v : cell.vertices)
          {
            segment.all.include(vertices[v][0]);
            if (tissue.liquid)
              segment.liquid.include(vertices[v][0]);
          }
        for (unsigned int f = 0; f < 6; ++f)
          {
            const double x =
              plane_of_face(vertices,
                            cell,
                            curved_cells.empty() ? nullptr : &curved_cells[c],
                            f,
                            tolerance);
            if (std::isnan(x))
              continue;
            if (tissue.wall_layer)
              segment.wall_planes.insert(x);
            if (tissue.liquid == has_liquid)
              segment.middle_planes.insert(x);
          }
      }

    for (const CavityWall &wall : cavities)
      {
        Along &segment = segments[wall.segment];
        segment.middle_planes.clear();
        for (std::size_t c = 0; c < cells.size(); ++c)
          for (unsigned int f = 0; f < 6; ++f)
            {
              const FaceKey key = face_key(cells[c], f);
              const auto    id  = boundary_ids.find(key);
              if (id == boundary_ids.end() || id->second != wall.boundary)
                continue;
              for (const unsigned int v : key)
                {
                  const double x = vertices[v][0];
                  segment.liquid.include(x);
                  for (const unsigned int w : key)
                    if (v < w && std::abs(x - vertices[w][0]) < tolerance &&
                        (curved_cells.empty() ||
                         std::abs(x - curved_cells[c].node_between(v, w)[0]) <
                           tolerance))
                      segment.middle_planes.insert(x);
                }
            }
      }

    std::vector<SegmentSections> sections;
    for (const Along &segment : segments)
      {
        const Extent1d extent =
          segment.liquid.empty() ? segment.all : segment.liquid;
        const double middle   = (extent.begin + extent.end) / 2;
        const double distance = (extent.end - extent.begin) / 4;
        sections.push_back(
          {nearest_plane(segment.wall_planes, extent.begin, distance),
           nearest_plane(segment.middle_planes, middle, distance),
           nearest_plane(segment.wall_planes, extent.end, distance)});
      }
    return sections;
  }



  std::array<dealii::Point<dim>, 3>
  mesh_support_points(const Vertices                &vertices,
                      const Cells                   &cells,
                      const std::vector<TissueName> &tissues)
  {
    std::set<unsigned int> wall, all;
    for (const auto &cell : cells)
      for (const unsigned int v : cell.vertices)
        {
          all.insert(v);
          if (!tissues[Region::of(cell.material_id).tissue].liquid)
            wall.insert(v);
        }
    const std::set<unsigned int> &candidates = wall.empty() ? all : wall;

    // The candidate for which a measure is smallest; measures that differ by
    // round-off are the same, and the next entry decides.
    double size = 0.;
    for (const unsigned int v : candidates)
      size =
        std::max(size, vertices[v].distance(vertices[*candidates.begin()]));
    const auto rounded = [size](const double x) {
      return std::round(1e8 * x / size);
    };
    const auto best = [&](const auto &measure) {
      return vertices[*std::min_element(
        candidates.begin(), candidates.end(), [&](const auto a, const auto b) {
          return measure(vertices[a]) < measure(vertices[b]);
        })];
    };

    const auto A = best([&](const auto &X) {
      return std::make_tuple(rounded(X[0]),
                             rounded(std::hypot(X[1], X[2])),
                             rounded(X[1]),
                             rounded(X[2]));
    });
    const auto B = best([&](const auto &X) {
      return std::make_tuple(rounded(-X[0]),
                             rounded(std::hypot(X[1] - A[1], X[2] - A[2])),
                             rounded(X[1]),
                             rounded(X[2]));
    });
    // A motion along y at C is that of a spin about the line AB.
    const double slope = (B[2] - A[2]) / (B[0] - A[0]);
    const auto   C     = best([&](const auto &X) {
      const double lever = X[2] - A[2] - slope * (X[0] - A[0]);
      return std::make_tuple(-rounded(std::abs(lever)),
                             rounded(std::abs(X[0] - A[0])),
                             rounded(std::abs(X[1] - A[1])),
                             rounded(-lever));
    });
    return {{A, B, C}};
  }
} // namespace lumbricus
