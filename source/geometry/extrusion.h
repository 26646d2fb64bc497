// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_extrusion_h
#define lumbricus_geometry_extrusion_h

#include <lumbricus/geometry/geometry.h>

#include <functional>
#include <optional>
#include <vector>

#include "cross_section.h"

namespace lumbricus
{
  /** A plane x = const of the coarse mesh, and the ring radii in it. */
  struct AxialStation
  {
    /** Its place on the axis [mm]. */
    double x;
    /** As CrossSection::position() takes them [mm]. */
    std::vector<double> radii;
  };



  /** The kinds of surface an extruded body has. */
  enum class BodySurface
  {
    /** The plane of the first station. */
    head,
    /** The plane of the last station. */
    tail,
    /** The outermost circles. */
    outer,
    /** The innermost circles of a hollow body. */
    inner,
    /** Around a part without cells. */
    chamber,
    /** The plane y = 0 of a half or a quarter. */
    symmetry_y,
    /** The plane z = 0 of a quarter. */
    symmetry_z
  };



  /** Region of the cells of a ring in the slab behind a station; nothing where
   * there are to be no cells. */
  using RegionOfCell =
    std::function<std::optional<Region>(const unsigned int slab,
                                        const unsigned int ring)>;

  /** Boundary id of the faces that cells of a ring have on a surface. The slab
   * is that of the cells, or that of the part without cells. */
  using BoundaryOfFace =
    std::function<dealii::types::boundary_id(const BodySurface  surface,
                                             const unsigned int ring,
                                             const unsigned int slab)>;

  /**
   * Sweep @p section along the x axis: one slab of hexahedra between each two
   * consecutive stations. Cells are right-handed, and lines that face each
   * other point the same way. Faces between rings and between slabs are in
   * standard orientation. Some others are seen transposed by one of their two
   * cells: those over some edges of the core and some diagonals. That cannot
   * be avoided where three cells meet at a corner of the core.
   *
   * The circles and all cells outside radii[0] carry a cylindrical manifold
   * about the x axis: in the coordinates (r, phi, x) a new point is a mean of
   * old ones, so circles stay circles, cones between stations of different
   * radius stay cones, and planes x = const stay plane. The disk inside is
   * flat but for its rim.
   */
  void
  extrude(const CrossSection              &section,
          const std::vector<AxialStation> &stations,
          const RegionOfCell              &region,
          const BoundaryOfFace            &boundary,
          dealii::Triangulation<dim>      &triangulation);
} // namespace lumbricus

#endif
