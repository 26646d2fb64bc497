// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_multigrid_level_matrix_h
#define lumbricus_multigrid_level_matrix_h

#include <lumbricus/discretization/cell_unknowns.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/partitioner.h>
#include <deal.II/base/types.h>

#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace lumbricus
{
  /**
   * The assembled matrix of a mesh in its free unknowns, C^T K C: the rows that
   * this rank owns, and copies of the other rows its cells have, compressed, in
   * single precision. reinit() and finish() are collective.
   */
  class LevelMatrix
  {
  public:
    /** An entry's column is a place in the vectors of this matrix. */
    struct Row
    {
      const unsigned int *columns; ///< size of them
      const float        *values;  ///< as many
      unsigned int        size;    ///< entries of the row
    };

    /** The pattern, for the first @p n_cells cells of @p unknowns. */
    void
    reinit(const CellUnknowns &unknowns,
           const unsigned int  n_cells,
           const MPI_Comm      comm);

    /** Before the matrices of all cells are added. */
    void
    begin();

    /** Add the matrix of cell @p i, by rows, with its constraints applied. */
    void
    add(const unsigned int i, const std::vector<double> &matrix);

    /** After all were added. */
    void
    finish();

    /** Give @p x the entries of all columns. */
    void
    reinit_vector(Vector &x) const
    {
      x.reinit(columns);
    }

    /** The ranks that the rows are shared among. */
    MPI_Comm
    communicator() const
    {
      return comm;
    }

    /** How many rows this rank owns. */
    unsigned int
    n_owned() const
    {
      return columns->locally_owned_size();
    }

    /** Owned entries of a vector and those of other ranks. */
    unsigned int
    n_places() const
    {
      return columns->locally_owned_size() + columns->n_ghost_indices();
    }

    /** The row of the unknown at @p place. */
    Row
    row(const unsigned int place) const
    {
      const unsigned int r =
        place < n_owned() ? place : copy_at[place - n_owned()];
      return {column.data() + row_begin[r],
              values.data() + row_begin[r],
              static_cast<unsigned int>(row_begin[r + 1] - row_begin[r])};
    }

    /** r = b - A x on the owned rows; @p x has its ghost values. */
    void
    residual(const Vector &x, const double *b, double *r) const;

    /** The free unknowns of owned cell @p i, as places. */
    const std::vector<unsigned int> &
    unknowns_of_cell(const unsigned int i) const
    {
      return of_cell[i];
    }

  private:
    /** Append to the columns of the owned rows, in global numbers, those of the
     * rows @p wanted from their owners; @p firsts are the ranks' first rows. */
    void
    exchange_rows(
      const std::vector<dealii::types::global_dof_index>        &wanted,
      const std::vector<dealii::types::global_dof_index>        &firsts,
      const dealii::types::global_dof_index                      first,
      std::vector<std::vector<dealii::types::global_dof_index>> &rows);

    void
    add_rows(const unsigned int cell, const double *matrix);

    MPI_Comm     comm          = MPI_COMM_NULL;
    unsigned int n_owned_cells = 0;

    std::shared_ptr<const dealii::Utilities::MPI::Partitioner> columns;
    /** Of the owned cells, then those of other ranks that touch owned rows:
     * the places of their free unknowns, and the order that sorts these. */
    std::vector<std::vector<unsigned int>> of_cell;
    std::vector<std::vector<unsigned int>> sorted;
    /** To whom an owned cell's matrix goes as well; from whom others come. */
    std::vector<std::vector<unsigned int>>             receivers;
    std::vector<std::pair<unsigned int, unsigned int>> received; // rank, cells
    std::map<unsigned int, std::vector<double>>        outgoing;

    /** Owned rows that go to other ranks; first copy, by the rank they come
     * from; and of each place that is not owned the row, if there is one. */
    std::map<unsigned int, std::vector<unsigned int>> rows_for;
    std::map<unsigned int, unsigned int>              first_copy_from;
    std::vector<unsigned int>                         copy_at;

    std::vector<std::size_t>  row_begin = {0};
    std::vector<unsigned int> column;
    std::vector<float>        values;
  };
} // namespace lumbricus

#endif
