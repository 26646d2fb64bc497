// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_surface_matrix_h
#define lumbricus_discretization_surface_matrix_h

#include <lumbricus/discretization/cell_sizes.h>

#include <vector>

namespace lumbricus
{
  /** What loads on its surface add to the matrix of a cell. Next to all of them
   * hang on the nodes of a face only, so that most rows and columns are zero: those
   * are left out as soon as the matrix is used. */
  class SurfaceMatrix
  {
  public:
    /** Rows and columns of a cell's matrix. */
    static constexpr unsigned int n = cell_sizes::n_per_cell;

    /** All entries by rows, zero at first, to be added to. */
    std::vector<double> &
    entries();

    /** y += S x. */
    void
    vmult_add(const double *x, double *y) const;

    /** K += S, by rows. */
    void
    add_to(std::vector<double> &K) const;

    /** d += the diagonal of S. */
    void
    add_diagonal_to(double *d) const;

  private:
    /** Leave out the zeros. */
    void
    pack() const;

    // All entries, or none where they are packed: those of the rows and columns at
    // these places.
    mutable std::vector<double>       all;
    mutable std::vector<unsigned int> places;
    mutable std::vector<double>       packed;
  };
} // namespace lumbricus

#endif
