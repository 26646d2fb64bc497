// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_errors_family_functions_h
#define lumbricus_errors_family_functions_h

#include <lumbricus/discretization/cell_unknowns.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/lac/full_matrix.h>

#include <array>
#include <utility>
#include <vector>

namespace lumbricus
{
  /**
   * The functions of the Enrichment on a large cell and its eight children, and E,
   * which makes unknowns of a child of them. First come the displacements: on line l
   * of three nodes through the large cell in direction d, component c of the
   * function that is 1 at its first or second quarter (h) has the number
   * 3 (2 (9 d + l) + h) + c. The pressures follow.
   */
  class FamilyFunctions
  {
  public:
    /** Cells in place of a large one. */
    static constexpr unsigned int n_children =
      dealii::GeometryInfo<dim>::max_children_per_cell;
    /** Lines in one direction. */
    static constexpr unsigned int n_lines = 9;
    /** Of displacements. */
    static constexpr unsigned int n_displacements = dim * n_lines * 2 * dim;
    /** Of the pressure. */
    static constexpr unsigned int n_pressures = dim * (dim + 1) / 2;
    /** All of them. */
    static constexpr unsigned int n = n_displacements + n_pressures;

    /** Compute E. */
    FamilyFunctions();

    /** Where each displacement is 1: a child and its unknown. */
    using Nodes =
      std::array<std::pair<unsigned int, unsigned int>, n_displacements>;

    /** Those of all. */
    const Nodes &
    nodes() const
    {
      return all_nodes;
    }

    /** Whether unknown @p k of @p child is a displacement of a node that the large
     * cell has too. */
    bool
    is_of_large_cell(const unsigned int child, const unsigned int k) const
    {
      return children[child].of_large_cell[k];
    }

    /** Add E^T K E of the matrix @p K of @p child, by rows, to the first rows and
     * columns of @p sum. */
    void
    add_matrix(const unsigned int          child,
               const std::vector<double>  &K,
               dealii::FullMatrix<double> &sum) const;

    /** @p f += E^T r, with the unknowns @p r of @p child. */
    void
    add_transposed(const unsigned int child, const double *r, double *f) const;

    /** @p x = E f, the unknowns of @p child. */
    void
    evaluate(const unsigned int child, const double *f, double *x) const;

    /** C^(-1) B and C^(-1) of a matrix [A B^T; B C] of displacements and
     * pressures. */
    struct Elimination
    {
      /** C^(-1) B, of all rows of the matrix: the identity for the pressures. */
      dealii::FullMatrix<double> of_displacements;
      dealii::FullMatrix<double> of_pressures; ///< C^(-1)
    };

    /** Replace A in @p matrix by A - B^T C^(-1) B; after the n functions there may
     * be more displacements. */
    static Elimination
    eliminate_pressures(dealii::FullMatrix<double> &matrix);

  private:
    /** An entry of E. */
    struct Entry
    {
      unsigned int row;    ///< unknown of the child
      unsigned int column; ///< function, of those of the child
      double       weight; ///< its value there
    };

    /** E of a child. */
    struct Child
    {
      std::vector<Entry>        entries;
      std::vector<unsigned int> functions; ///< that are not zero on it
      /** Of each unknown whether the large cell has it too. */
      std::array<bool, CellUnknowns::n_per_cell> of_large_cell = {};
    };

    /** One more entry, in the column of a function. */
    static void
    add(Child             &child,
        const unsigned int row,
        const unsigned int function,
        const double       weight);

    /** E of displacements, and their nodes. */
    void
    embed_displacements();

    /** E of pressures. */
    void
    embed_pressures();

    std::array<Child, n_children> children;
    Nodes                         all_nodes;
  };
} // namespace lumbricus

#endif
