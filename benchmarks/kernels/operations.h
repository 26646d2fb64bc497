// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_benchmarks_kernels_operations_h
#define lumbricus_benchmarks_kernels_operations_h

#include <lumbricus/discretization/cell_linearisation.h>

// Floating point operations per cell, counted from the loops of
// cell_linearisation.cc, element_kernel.cc and the laws: an addition, a product
// or a function is one. What the loops compute on the padding of nodes and
// points is not counted: it is of no use.
namespace operations
{
  using lumbricus::dim;

  constexpr double n_nodes = lumbricus::MixedSpace::n_nodes;
  constexpr double n_modes = lumbricus::MixedSpace::n_pressure_modes;
  constexpr double n_q     = lumbricus::MixedSpace::n_q_points;

  /** Of a law at a point. */
  struct Law
  {
    /** P, Q, c and dc_dp: det F (14), F^(-1) (42), bbar (106), taubar (6), tau
     * (16), P (45), Q (9), c (4). */
    double residual = 242.;
    /** A: spatial_tangent() (561), B (432), A (405). */
    double tangent = 1398.;
  };

  constexpr Law neo_hooke;
  /** taubar takes 73, and cbar is not zero: 8 for each of 36 entries. */
  constexpr Law mooney_rivlin{242. - 6. + 73., 1398. + 288.};

  /** From values at nodes to gradients at points, or back: nine sums over the
   * nodes at each point. */
  constexpr double gradients = n_q * dim * dim * 2. * n_nodes;
  /** The same for pressures. */
  constexpr double pressures = n_q * 2. * n_modes;

  /** Grad u + I and its determinant, p, the law, the force with P times JxW,
   * the change of volume with two products per mode more. */
  constexpr double
  residual(const Law &law)
  {
    return gradients + n_q * (dim + 14.) + pressures + n_q * law.residual +
           gradients + n_q * dim * dim + pressures + n_q * n_modes;
  }

  /** That, the derivatives, and their 45 + 9 + 1 products with JxW. */
  constexpr double
  linearisation(const Law &law)
  {
    return residual(law) + n_q * (law.tangent + 55.);
  }

  /** H: 18 rows at each point of three products and two sums per node; K_up:
   * as much and n_modes products and sums for each component and node; K_pp:
   * two products and a sum; K_uu: the six blocks of G^T H. */
  constexpr double matrix =
    n_q * 18. * 5. * n_nodes + n_q * dim * n_nodes * (5. + 2. * n_modes) +
    n_q * 3. * n_modes * n_modes + 2. * (n_q * dim) * n_nodes * (6. * n_nodes);

  /** Gradients and pressures there and back; between them 9 products of A on
   * its diagonal, 72 beside it, 18 of Q, 1 of dc_dp, each with its sum. */
  constexpr double vmult =
    2. * gradients + 2. * pressures + n_q * 2. * (9. + 72. + 18. + 1.);

  /** Bytes that vmult() has to read and write. */
  constexpr double vmult_bytes =
    sizeof(lumbricus::CellLinearisation) +
    sizeof(double) * (n_q * dim * lumbricus::ShapeCache::padded_nodes +
                      2. * lumbricus::CellLinearisation::n_unknowns);
} // namespace operations

#endif
