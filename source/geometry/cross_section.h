// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_cross_section_h
#define lumbricus_geometry_cross_section_h

#include <deal.II/base/point.h>

#include <array>
#include <vector>

namespace lumbricus
{
  /**
   * A disk surrounded by rings, cut into quadrilaterals, in the plane (y, z).
   *
   *      z |.
   *        |   ' .         One quarter: a core of m x m quads, rings of 2m
   *        |       ' .     quads from the core to the circle of the liquid,
   *        |. _       '.   then the layers of the wall. A half and the full
   *        |    ' .     '  section are quarters turned by right angles that
   *        |       |     . share their vertices, so that the meshes of all
   *        |_______|_____| three coincide where they overlap.
   *                      y
   *
   * The pattern has no size. A vertex gets its place from the ring radii of
   * the axial station it is used at,
   *
   *   radii = { liquid, layer 1 outside, layer 2 outside, ... }.
   */
  class CrossSection
  {
  public:
    /** How much of the circle: half is y >= 0, quarter is y >= 0, z >= 0. */
    enum class Part
    {
      full,
      half,
      quarter
    };

    /** What an edge of a quadrilateral belongs to. */
    enum class Side
    {
      /** Between two cells. */
      interior,
      /** The outermost circle. */
      outer,
      /** The innermost circle of a hollow section. */
      inner,
      /** The plane y = 0. */
      symmetry_y,
      /** The plane z = 0. */
      symmetry_z
    };

    /** A cell of the section. */
    struct Quad
    {
      /** In deal.II's order; counterclockwise seen against the x axis. */
      std::array<unsigned int, 4> vertices;
      /** 0 in the disk, then the number of the layer of the wall. */
      unsigned int ring;
      /** Indexed like the lines of a deal.II quadrilateral. */
      std::array<Side, 4> sides;
    };

    /**
     * @param n_around_quarter cells around a quarter, 2m: even.
     * @param filled whether there is a disk inside radii[0].
     * @param n_disk_rings cells from the core to the circle of the liquid.
     * @param n_layer_cells cells across each layer of the wall; at least one
     * layer.
     */
    CrossSection(const Part                       part,
                 const unsigned int               n_around_quarter,
                 const bool                       filled,
                 const unsigned int               n_disk_rings,
                 const std::vector<unsigned int> &n_layer_cells);

    /** How many vertices the quadrilaterals have together. */
    unsigned int
    n_vertices() const
    {
      return vertices.size();
    }

    /** How many layers the wall has. */
    unsigned int
    n_layers() const
    {
      return n_wall_layers;
    }

    /** All quadrilaterals: of the disk from the core outwards, then of the
     * layers, ring by ring. */
    const std::vector<Quad> &
    quads() const
    {
      return quad_list;
    }

    /** (y, z) of a vertex at a station with these ring radii. */
    dealii::Point<2>
    position(const unsigned int vertex, const std::vector<double> &radii) const;

  private:
    /**
     * In the disk (ring 0): at radii[0] * direction, |direction| <= 1. In
     * layer k: at distance (1-f) radii[k-1] + f radii[k], |direction| = 1.
     */
    struct Vertex
    {
      dealii::Point<2> direction;
      unsigned int     ring;
      double           fraction;
    };

    class Builder;

    /** Append a quad given by its corners, counterclockwise from @p first. */
    void
    add_quad(const std::array<unsigned int, 4> &corners,
             const unsigned int                 first,
             const unsigned int                 ring);

    /** Tell what the edges of all quads belong to, when all vertices are
     * there. */
    void
    find_sides();

    Side
    side(const Vertex &a, const Vertex &b) const;

    const Part          part;
    const bool          filled;
    const unsigned int  n_wall_layers;
    std::vector<Vertex> vertices;
    std::vector<Quad>   quad_list;
  };
} // namespace lumbricus

#endif
