// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_output_cavity_points_h
#define lumbricus_output_cavity_points_h

#include <lumbricus/output/field_point.h>

#include <functional>
#include <string>

namespace lumbricus
{
  /** The tissue that chambers without cells are of in pictures: the first liquid
   * one of @p geometry, or, where it has none, one more than it has. */
  unsigned int
  tissue_of_cavities(const Geometry &geometry);

  /** The name of that one more. */
  extern const std::string cavity_tissue;

  /**
   * Fill the chambers without cells with cells for pictures, one between each face
   * of the wall around a chamber, which is its first, and the middle of the chamber,
   * to which its last face has shrunk: to a point, or, between pistons, to lines
   * along the axis. At rest and deformed they make up the volume inside exactly.
   *
   * Call @p visit at the 27 nodes of each such cell of this rank, which FieldPoint::q
   * counts as (x fastest) deal.II does. FieldPoint::cell is the cell behind the
   * face, J the volume of the whole chamber over that at rest, and sigma = -p I with the pressure p
   * there. Collective.
   */
  void
  visit_cavity_points(const Body                              &body,
                      const LiquidWeight                      &weight,
                      const State                             &state,
                      const std::function<void(FieldPoint &)> &visit);
} // namespace lumbricus

#endif
