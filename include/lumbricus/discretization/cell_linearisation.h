// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_cell_linearisation_h
#define lumbricus_discretization_cell_linearisation_h

#include <lumbricus/discretization/cell_unknowns.h>
#include <lumbricus/discretization/shape_cache.h>
#include <lumbricus/materials/material_law.h>

#include <vector>

namespace lumbricus
{
  /**
   * The linearisation of a cell's integrals, as the derivatives of its
   * material's response at the quadrature points (MaterialResponse) times the
   * volume there: enough to apply the tangent without its matrix,
   *
   *   (K dx)_u = int (A : Grad du + Q dp) : Grad du' dV,
   *   (K dx)_p = int (Q : Grad du + dc/dp dp) dp' dV,
   *
   * and to compute the matrix where a solver wants that. A is symmetric: its
   * 45 entries on and above the diagonal are kept. About 14 kB.
   */
  class CellLinearisation
  {
  public:
    /** Rows and columns of the matrix. */
    static constexpr unsigned int n_unknowns = CellUnknowns::n_per_cell;

    /** Set what belongs to quadrature point @p q, with the volume @p JxW. */
    void
    set(const unsigned int      q,
        const MaterialResponse &response,
        const double            JxW);

    /** y = K x, in the order of CellUnknowns. */
    void
    vmult(const ShapeCache::Cell &cell,
          const double           *pressure_modes,
          const double           *x,
          double                 *y) const;

    /** Set @p K to the matrix, by rows, in the order of CellUnknowns: that of
     * vmult(), or, @p for_preconditioner, with what MaterialResponse::mu_missing
     * adds in liquid that flows. */
    void
    matrix(const ShapeCache::Cell &cell,
           const double           *pressure_modes,
           const bool              for_preconditioner,
           std::vector<double>    &K) const;

    /** Set @p d to the diagonal of matrix() for preconditioners, in the order of
     * CellUnknowns. */
    void
    diagonal(const ShapeCache::Cell &cell,
             const double           *pressure_modes,
             double                 *d) const;

  private:
    static constexpr unsigned int n_q      = MixedSpace::n_q_points;
    static constexpr unsigned int padded_q = 32;
    static constexpr unsigned int n_pairs  = dim * dim * (dim * dim + 1) / 2;

    /** Where A[a][b] is kept, a <= b. */
    static constexpr unsigned int
    pair(const unsigned int a, const unsigned int b)
    {
      return a * dim * dim - a * (a + 1) / 2 + b;
    }

    /** Add to @p stiffness, dP_iJ / dF_kL by rows, what liquid that flows lacks
     * for a preconditioner at point @p q with the volume @p JxW. */
    void
    add_missing_stiffness(const unsigned int q,
                          const double       JxW,
                          double (&stiffness)[dim * dim][dim * dim]) const;

    alignas(64) double A[n_pairs][padded_q]   = {};
    alignas(64) double Q[dim * dim][padded_q] = {};
    alignas(64) double dc_dp[padded_q]        = {};
    double             mu_missing             = 0.;
  };
} // namespace lumbricus

#endif
