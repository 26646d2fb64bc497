// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_multigrid_embedding_h
#define lumbricus_multigrid_embedding_h

#include <lumbricus/discretization/cell_unknowns.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/lac/full_matrix.h>

#include <array>
#include <vector>

namespace lumbricus
{
  /**
   * The functions of a cell as functions of its children: x_child = P_c x,
   * which is exact, as both elements are polynomials in the cell's own
   * coordinates. P_c is the same for all cells,
   *
   *   P_c = [ Q_c (x) I_3   0  ]
   *         [      0       R_c ],   Q_c 27 x 27, R_c 4 x 4,
   *
   * in the order of CellUnknowns.
   */
  class Embedding
  {
  public:
    /** Unknowns of a cell, as CellUnknowns orders them. */
    static constexpr unsigned int n_per_cell = CellUnknowns::n_per_cell;
    /** A cell is cut into eight. */
    static constexpr unsigned int n_children =
      dealii::GeometryInfo<dim>::max_children_per_cell;

    /** Compute P_c of all children. */
    Embedding();

    /** child = P_c parent. */
    void
    embed(const unsigned int c, const double *parent, double *child) const;

    /** parent += P_c^T child. */
    void
    add_transposed(const unsigned int c,
                   const double      *child,
                   double            *parent) const;

    /** parent += P_c^T child P_c for square matrices by rows. */
    void
    add_galerkin(const unsigned int         c,
                 const std::vector<double> &child,
                 std::vector<double>       &parent) const;

  private:
    /** An entry of P_c: row and column in the order of CellUnknowns. */
    struct Entry
    {
      unsigned int row, column;
      double       weight;
    };

    std::array<std::vector<Entry>, n_children> entries;
  };
} // namespace lumbricus

#endif
