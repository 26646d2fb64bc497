// SPDX-License-Identifier: LGPL-2.1-or-later

#include "cross_section.h"

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace lumbricus
{
  using dealii::Point;

  namespace
  {
    // Turned about the x axis by @p q right angles, without rounding.
    Point<2>
    turned(const Point<2> &p, const unsigned int q)
    {
      switch (q % 4)
        {
          case 0:
            return p;
          case 1:
            return {-p[1], p[0]};
          case 2:
            return {-p[0], -p[1]};
          default:
            return {p[1], -p[0]};
        }
    }



    // The direction of the angle pi/2 * a/(2m), symmetric about the diagonal.
    Point<2>
    on_unit_circle(const unsigned int a, const unsigned int m)
    {
      const unsigned int b     = std::min(a, 2 * m - a);
      const double       angle = dealii::numbers::PI_4 * b / m;
      const double       c = std::cos(angle), s = std::sin(angle);
      return b == a ? Point<2>(c, s) : Point<2>(s, c);
    }
  } // namespace



  /**
   * Makes the vertices and quads of a section from inside to outside. Quarters
   * are counted counterclockwise from the positive y axis; a half starts with
   * the fourth of them. A line of vertices around the axis is closed in a full
   * section and open else; vertex a of a line is at the angle a/(2m) of a right
   * angle.
   */
  class CrossSection::Builder
  {
  public:
    /** For @p section, which is kept by reference and is empty so far; the
     * other arguments are those of its constructor. */
    Builder(CrossSection      &section,
            const unsigned int n_around_quarter,
            const unsigned int n_disk_rings)
      : section(section)
      , n_around_quarter(n_around_quarter)
      , n_disk_rings(n_disk_rings)
      , m(n_around_quarter / 2)
      , n_quarters(section.part == Part::full ? 4 :
                   section.part == Part::half ? 2 :
                                                1)
      , first_quarter(section.part == Part::half ? 3 : 0)
      , closed(section.part == Part::full)
      , n_angles(n_quarters * n_around_quarter)
      , core(m, n_disk_rings)
      , line(closed ? n_angles : n_angles + 1)
    {}

    /** The quads of the core. */
    void
    add_core()
    {
      for (unsigned int q = 0; q < n_quarters; ++q)
        for (unsigned int j = 0; j < m; ++j)
          for (unsigned int i = 0; i < m; ++i)
            // Starting at the corner with the lowest y and z makes the lines
            // of all cells of the core point along the positive axes.
            section.add_quad({{core_vertex(q, i, j),
                               core_vertex(q, i + 1, j),
                               core_vertex(q, i + 1, j + 1),
                               core_vertex(q, i, j + 1)}},
                             4 - (first_quarter + q) % 4,
                             0);
    }

    /** Start the lines with the outline of the core. */
    void
    start_around_core()
    {
      for (unsigned int a = 0; a < line.size(); ++a)
        {
          const unsigned int q = quarter_of(a);
          const unsigned int b = a - q * n_around_quarter;
          line[a] =
            b <= m ? core_vertex(q, m, b) : core_vertex(q, 2 * m - b, m);
        }
    }

    /** Start the lines with the innermost circle of a hollow section. */
    void
    start_on_circle()
    {
      for (unsigned int a = 0; a < line.size(); ++a)
        line[a] = add_vertex({circle_point(a), 0, 1.});
    }

    /** The rings between the outline of the core and the circle of the
     * liquid. */
    void
    add_disk_rings()
    {
      const std::vector<unsigned int> core_line = line;
      for (unsigned int k = 1; k <= n_disk_rings; ++k)
        append_line(0, [&](const unsigned int a) -> Vertex {
          if (k == n_disk_rings)
            return {circle_point(a), 0, 1.};
          const double    f      = double(k) / n_disk_rings;
          const Point<2> &inside = section.vertices[core_line[a]].direction;
          return {Point<2>((1 - f) * inside + f * circle_point(a)), 0, 1.};
        });
    }

    /** The rings of a layer of the wall, counted from 1. */
    void
    add_layer(const unsigned int layer, const unsigned int n_cells)
    {
      for (unsigned int k = 1; k <= n_cells; ++k)
        append_line(layer, [&](const unsigned int a) -> Vertex {
          return {circle_point(a), layer, double(k) / n_cells};
        });
    }

  private:
    // The core of one quarter in the unit disk. Its outer edges are bulged
    // (parabolas from the axes to the corner), so that the three cells that
    // meet at the corner share the full angle more evenly.
    class Core
    {
    public:
      Core(const unsigned int m, const unsigned int n_rings)
        : m(m)
        // Core cells about as large as the rings are wide, within the limits
        // in which all angles stay between 54 and 126 degrees.
        , axis(std::clamp(double(m) / (m + n_rings), 0.45, 0.65))
        , bulge(0.14 * axis)
      {}

      Point<2>
      position(const unsigned int i, const unsigned int j) const
      {
        const double u = double(i) / m, v = double(j) / m;
        return {u * (axis - bulge * v * v), v * (axis - bulge * u * u)};
      }

    private:
      const unsigned int m;
      const double       axis;
      const double       bulge;
    };

    unsigned int
    add_vertex(const Vertex &vertex)
    {
      section.vertices.push_back(vertex);
      return section.vertices.size() - 1;
    }

    // A vertex of the core: quarter q counted from the first, i and j along
    // its two edges. The second edge of a quarter is the first of the next.
    unsigned int
    core_vertex(unsigned int q, unsigned int i, unsigned int j)
    {
      if (i == 0 && j == 0)
        q = 0;
      else if (i == 0 && (closed || q + 1 < n_quarters))
        {
          q = (q + 1) % n_quarters;
          std::swap(i, j);
        }
      const auto entry =
        core_numbers.emplace(std::array<unsigned int, 3>{{q, i, j}},
                             section.n_vertices());
      if (entry.second)
        add_vertex({turned(core.position(i, j), first_quarter + q), 0, 1.});
      return entry.first->second;
    }

    // The quarter that vertex a of a line is computed in.
    unsigned int
    quarter_of(const unsigned int a) const
    {
      return std::min(a / n_around_quarter, n_quarters - 1);
    }

    // The direction of vertex a of a line.
    Point<2>
    circle_point(const unsigned int a) const
    {
      const unsigned int q = quarter_of(a);
      return turned(on_unit_circle(a - q * n_around_quarter, m),
                    first_quarter + q);
    }

    // Join the last line with a new one by quads, which belong to @p ring. As
    // in the core, lines that face each other point the same way.
    template <typename VertexAt>
    void
    append_line(const unsigned int ring, const VertexAt &vertex_at)
    {
      std::vector<unsigned int> next;
      for (unsigned int a = 0; a < line.size(); ++a)
        next.push_back(add_vertex(vertex_at(a)));
      for (unsigned int a = 0; a < n_angles; ++a)
        {
          const unsigned int b = (a + 1) % line.size();
          // 0: around the positive y axis, then counterclockwise.
          const unsigned int sector = ((2 * first_quarter + a / m + 1) / 2) % 4;
          const bool         turned_about = sector == 1 || sector == 2;
          section.add_quad({{line[a], next[a], next[b], line[b]}},
                           turned_about ? 3 : 0,
                           ring);
        }
      line = next;
    }

    CrossSection      &section;
    const unsigned int n_around_quarter;
    const unsigned int n_disk_rings;
    const unsigned int m;
    const unsigned int n_quarters;
    const unsigned int first_quarter;
    const bool         closed;
    const unsigned int n_angles;
    const Core         core;

    // The numbers of the vertices of the core, by quarter, i and j.
    std::map<std::array<unsigned int, 3>, unsigned int> core_numbers;
    // The outermost line so far.
    std::vector<unsigned int> line;
  };



  CrossSection::CrossSection(const Part                       part,
                             const unsigned int               n_around_quarter,
                             const bool                       filled,
                             const unsigned int               n_disk_rings,
                             const std::vector<unsigned int> &n_layer_cells)
    : part(part)
    , filled(filled)
    , n_wall_layers(n_layer_cells.size())
  {
    Assert(n_around_quarter >= 2 && n_around_quarter % 2 == 0,
           dealii::ExcMessage("An even number of cells around a quarter."));
    Assert(!filled || n_disk_rings >= 1,
           dealii::ExcMessage("At least one ring between core and circle."));
    Assert(n_wall_layers >= 1, dealii::ExcMessage("At least one layer."));

    Builder builder(*this, n_around_quarter, n_disk_rings);
    if (filled)
      {
        builder.add_core();
        builder.start_around_core();
        builder.add_disk_rings();
      }
    else
      builder.start_on_circle();
    for (unsigned int layer = 1; layer <= n_wall_layers; ++layer)
      builder.add_layer(layer, n_layer_cells[layer - 1]);
    find_sides();
  }



  void
  CrossSection::find_sides()
  {
    static constexpr unsigned int line_ends[4][2] = {{0, 2},
                                                     {1, 3},
                                                     {0, 1},
                                                     {2, 3}};
    for (Quad &quad : quad_list)
      for (unsigned int l = 0; l < 4; ++l)
        {
          const Vertex &a = vertices[quad.vertices[line_ends[l][0]]];
          const Vertex &b = vertices[quad.vertices[line_ends[l][1]]];
          quad.sides[l]   = side(a, b);
        }
  }



  void
  CrossSection::add_quad(const std::array<unsigned int, 4> &corners,
                         const unsigned int                 first,
                         const unsigned int                 ring)
  {
    const auto corner = [&](const unsigned int i) {
      return corners[(first + i) % 4];
    };
    quad_list.push_back(
      {{{corner(0), corner(1), corner(3), corner(2)}}, ring, {}});
  }



  CrossSection::Side
  CrossSection::side(const Vertex &a, const Vertex &b) const
  {
    const auto both = [&](const auto &condition) {
      return condition(a) && condition(b);
    };
    // The zeros are exact: they come from the sine of zero and from turning.
    if (part != Part::full &&
        both([](const Vertex &v) { return v.direction[0] == 0.; }))
      return Side::symmetry_y;
    if (part == Part::quarter &&
        both([](const Vertex &v) { return v.direction[1] == 0.; }))
      return Side::symmetry_z;
    if (both([this](const Vertex &v) {
          return v.ring == n_wall_layers && v.fraction == 1.;
        }))
      return Side::outer;
    if (!filled && both([](const Vertex &v) { return v.ring == 0; }))
      return Side::inner;
    return Side::interior;
  }



  Point<2>
  CrossSection::position(const unsigned int         vertex,
                         const std::vector<double> &radii) const
  {
    Assert(radii.size() == n_wall_layers + 1,
           dealii::ExcDimensionMismatch(radii.size(), n_wall_layers + 1));
    const Vertex &v = vertices[vertex];
    if (v.ring == 0)
      return Point<2>(radii[0] * v.direction);
    const double inside = radii[v.ring - 1], outside = radii[v.ring];
    return Point<2>(((1 - v.fraction) * inside + v.fraction * outside) *
                    v.direction);
  }
} // namespace lumbricus
