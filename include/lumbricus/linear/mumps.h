// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_mumps_h
#define lumbricus_linear_mumps_h

#include <lumbricus/linear/free_numbering.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/mpi_noncontiguous_partitioner.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace lumbricus
{
  /** Entries of a matrix, each in its row and column, which are counted from
   * zero. Of a symmetric matrix either of two entries is to be there. */
  struct MatrixEntries
  {
    std::vector<unsigned int> rows;    ///< of each entry
    std::vector<unsigned int> columns; ///< of each entry
    std::vector<double>       values;  ///< in the unit of the matrix

    /** One entry more. */
    void
    add(const unsigned int row, const unsigned int column, const double value)
    {
      rows.push_back(row);
      columns.push_back(column);
      values.push_back(value);
    }

    /** Whether they are at the same places. */
    bool
    is_like(const MatrixEntries &other) const
    {
      return rows == other.rows && columns == other.columns;
    }
  };



  /** Unknowns of a matrix that no cell has, numbered after all others, and the
   * entries in their rows and columns. */
  struct MoreEntries
  {
    unsigned int  n_unknowns = 0; ///< the same on all ranks
    MatrixEntries own;            ///< what this rank adds
    MatrixEntries common;         ///< among these unknowns, known to all ranks

    /** Whether they are at the same places. */
    bool
    is_like(const MoreEntries &other) const
    {
      return n_unknowns == other.n_unknowns && own.is_like(other.own) &&
             common.is_like(other.common);
    }
  };



  /**
   * A factorisation by MUMPS (multifrontal, parallel): L D L^T of a symmetric
   * indefinite matrix or L U, in double or single precision (@p Number). Every
   * rank hands over the matrices of its own cells, which MUMPS adds up; the
   * symbolic analysis is done once for a pattern. But for the additions, all
   * functions are collective. Right-hand sides and solutions are never gathered
   * on a rank.
   */
  template <typename Number>
  class Mumps
  {
  public:
    /** What kind of matrix it is, and how it is factored. */
    struct Options
    {
      /** Whether it is L D L^T, of which only one triangle of a matrix is read;
       * else L U. */
      bool symmetric;
      /** Whether rows are exchanged for the sake of accuracy. */
      bool pivoting;
      /** Blocks far from the diagonal are compressed to low rank, up to this
       * error relative to the matrix; 0: not at all. */
      double compression;
    };

    /** Start MUMPS on the ranks of @p comm, for the free unknowns in @p numbering,
     * which is kept by reference. Where something goes wrong in the analysis or
     * the factorisation all ranks of @p told throw; they call these functions
     * together. */
    Mumps(const MPI_Comm       comm,
          const Options       &options,
          const FreeNumbering &numbering,
          const MPI_Comm       told);

    /** The same with all ranks of @p comm being told. */
    Mumps(const MPI_Comm       comm,
          const Options       &options,
          const FreeNumbering &numbering)
      : Mumps(comm, options, numbering, comm)
    {}

    ~Mumps();

    Mumps(const Mumps &) = delete;
    Mumps &
    operator=(const Mumps &) = delete;

    /**
     * For the sum of one square matrix per owned cell 0 ... @p n_cells - 1, in
     * the free unknowns of that cell without the first @p n_left_out of them,
     * and of the entries @p more: order the unknowns and plan the factorisation.
     * On one rank the unknowns with the numbers @p not_eliminated can be left:
     * see left_matrix(). Throws ExcSolveFailed when memory ends.
     */
    void
    analyse(const CellUnknowns              &unknowns,
            const unsigned int               n_cells,
            const unsigned int               n_left_out,
            const MoreEntries               &more           = {},
            const std::vector<unsigned int> &not_eliminated = {});

    /** Operations of the factorisation that is planned, on all ranks, without
     * compression. */
    double
    planned_flops() const;

    /** Memory it takes on the rank that needs most [MB]. */
    double
    planned_megabytes() const;

    /** Before the matrices of all cells are added. */
    void
    begin();

    /** Add the square matrix of the next cell, of size @p n, by rows. */
    void
    add(const unsigned int n, const double *matrix);

    /** After all cells: add the entries that analyse() was told of. */
    void
    add(const MoreEntries &more);

    /**
     * Factor the sum. Throws ExcNotConverged for a singular matrix,
     * ExcSolveFailed when memory ends.
     */
    void
    factor();

    /** Replace the right-hand side, this rank's entries in the order of the
     * numbering, by the solution; and, on the first rank, the entries of the
     * unknowns that no cell has. */
    void
    solve(std::vector<Number> &values, std::vector<Number> &more);

    /** The same where there are none of those. */
    void
    solve(std::vector<Number> &values)
    {
      std::vector<Number> none;
      solve(values, none);
    }

    /** After factor(): what is left of the matrix in the unknowns that are not
     * eliminated, A_ll - A_le A_ee^(-1) A_el, by rows; of a symmetric matrix the
     * triangle below the diagonal. */
    const std::vector<Number> &
    left_matrix() const
    {
      return left;
    }

    /** Subtract A_le A_ee^(-1) b_e from @p of_left, with the right-hand side
     * @p all of all unknowns by their numbers. */
    void
    reduce(std::vector<Number> &all, std::vector<Number> &of_left);

    /** After reduce() with the same right-hand side: replace it in @p all by the
     * solution, which is @p of_left in the unknowns that were not eliminated. */
    void
    expand(const std::vector<Number> &of_left, std::vector<Number> &all);

    /** Operations of the last factorisation on all ranks. */
    double
    factor_flops() const;

    /** Entries of the factors on all ranks. */
    double
    factor_entries() const;

    /** What the last factorisation cost, in back substitutions. */
    double
    factor_cost() const
    {
      return cost(factor_flops(), factor_entries());
    }

    /** What one with these operations and entries costs. */
    static double
    cost(const double flops, const double n_entries);

  private:
    struct Instance;

    /** Solve on one rank for all unknowns, @p values by their numbers. */
    void
    solve_alone(std::vector<Number> &values);

    /** Announce a square matrix in the unknowns at @p places. */
    void
    add_pattern(const unsigned int *places, const unsigned int n);

    void
    run(const int job);

    /** Analyse the announced pattern of so many unknowns. */
    void
    plan(const unsigned int n_unknowns);

    /** plan(), and the positions of the unknowns in the ordering that MUMPS has
     * taken. */
    std::vector<int>
    planned_positions(const unsigned int n_unknowns);

    /** Positions of the cells' unknowns, of which the last @p n_left are not
     * eliminated and come last. */
    std::vector<int>
    positions_with_left(const unsigned int n_left);

    /** The position of every unknown in an ordering with @p more, on all ranks,
     * as ordering_with() makes it. Those not eliminated, which have the last
     * numbers of the cells' unknowns and of the others, come last. */
    std::vector<int>
    order_with(const MoreEntries               &more,
               const std::vector<unsigned int> &not_eliminated);

    /** Throw where run() has failed at @p what: ExcNotConverged for a singular
     * matrix, or ExcSolveFailed. Collective. */
    void
    check(const std::string &what) const;

    const MPI_Comm            comm;
    const MPI_Comm            told;
    const bool                is_alone; // on its rank
    const bool                symmetric;
    const bool                compressed;
    const FreeNumbering      &numbering;
    std::unique_ptr<Instance> instance;
    std::size_t               next = 0;
    std::vector<int>          rows, columns;
    std::vector<Number>       entries;

    // The unknowns that are not eliminated, as MUMPS counts them.
    std::vector<int>    left_unknowns;
    std::vector<Number> left, reduced;

    // Right-hand sides of this rank, and solutions as MUMPS distributes them.
    std::vector<int>                               given, found;
    std::vector<Number>                            given_values, found_values;
    dealii::Utilities::MPI::NoncontiguousPartitioner to_given;
    bool                                           is_found_known = false;
  };
} // namespace lumbricus

#endif
