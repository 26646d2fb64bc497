// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_measures_mesh_quality_h
#define lumbricus_measures_mesh_quality_h

#include <lumbricus/discretization/body.h>

#include <array>
#include <vector>

namespace lumbricus
{
  /** Where the nodes of a cell are, in the order of FE_Q(2). */
  using NodePositions = std::array<dealii::Point<dim>, MixedSpace::n_nodes>;

  /**
   * How well shaped a cell of second order is: the least, over its 27 nodes, of
   * the scaled Jacobian
   *
   *   det(x_1, x_2, x_3) / (|x_1| |x_2| |x_3|),   x_k = dx/dxi_k.
   *
   * It is 1 where all angles are right ones, whatever the lengths, and not
   * positive where the cell is folded. At the corners of a cell with straight
   * edges it is the scaled Jacobian that ParaView and Verdict know (Knupp 2000,
   * International Journal for Numerical Methods in Engineering 48, 1165).
   */
  double
  scaled_jacobian(const NodePositions &x);

  /** The least scaled Jacobian of a segment's cells; 1 where it has none. */
  struct MeshQuality
  {
    /** Of the cells of its liquid. */
    double liquid = 1.;
    /** Of all its other cells. */
    double wall = 1.;
  };

  /** That of every segment, in the shape X + u, where @p relevant_solution is a
   * ghosted vector, or, without one, at rest. Collective. */
  std::vector<MeshQuality>
  mesh_qualities(const Body &body, const Vector *relevant_solution);
} // namespace lumbricus

#endif
