// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_nearness_h
#define lumbricus_geometry_nearness_h

#include <lumbricus/core/dimension.h>

#include <deal.II/base/point.h>

#include <array>
#include <utility>

namespace lumbricus
{
  /**
   * How far @p X is from the bilinear surface with these corners, in deal.II's
   * order, if the nearest point of it is inside of its edges; else infinite.
   */
  double
  distance_to_face(const std::array<dealii::Point<dim>, 4> &corners,
                   const dealii::Point<dim>                &X);

  /** How far @p X is from the straight edge from @p A to @p B. */
  double
  distance_to_edge(const dealii::Point<dim> &A,
                   const dealii::Point<dim> &B,
                   const dealii::Point<dim> &X);

  /**
   * The point of the edge from @p A to @p B where it is nearest to that from
   * @p C to @p D, and how far they are from each other there. It is infinite if
   * that is not inside of both, and for parallel edges.
   */
  std::pair<dealii::Point<dim>, double>
  nearest_of_edges(const dealii::Point<dim> &A,
                   const dealii::Point<dim> &B,
                   const dealii::Point<dim> &C,
                   const dealii::Point<dim> &D);

  /**
   * Whether @p X is inside of the trilinear hexahedron with these corners, in
   * deal.II's order: in the unit cell, more than @p margin from its faces.
   */
  bool
  is_inside(const std::array<dealii::Point<dim>, 8> &corners,
            const dealii::Point<dim>                &X,
            const double                             margin);
} // namespace lumbricus

#endif
