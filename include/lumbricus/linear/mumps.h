// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_mumps_h
#define lumbricus_linear_mumps_h

#include <lumbricus/linear/free_numbering.h>

#include <deal.II/base/mpi.h>

#include <memory>
#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * A factorisation by MUMPS (multifrontal, parallel): L D L^T of a symmetric
   * indefinite matrix or L U, in double or single precision (@p Number). Every
   * rank hands over the matrices of its own cells, which MUMPS adds up; the
   * symbolic analysis is done once for a pattern. But for the additions, all
   * functions are collective.
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

    /** Start MUMPS, for the free unknowns in @p numbering, which is kept by
     * reference. */
    Mumps(const MPI_Comm       comm,
          const Options       &options,
          const FreeNumbering &numbering);
    ~Mumps();

    Mumps(const Mumps &) = delete;
    Mumps &
    operator=(const Mumps &) = delete;

    /**
     * For the sum of one square matrix per owned cell 0 ... @p n_cells - 1, in
     * the free unknowns of that cell without the first @p n_left_out of them:
     * order the unknowns and plan the factorisation. Throws ExcSolveFailed when
     * memory ends.
     */
    void
    analyse(const CellUnknowns &unknowns,
            const unsigned int  n_cells,
            const unsigned int  n_left_out);

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

    /**
     * Factor the sum. Throws ExcNotConverged for a singular matrix,
     * ExcSolveFailed when memory ends.
     */
    void
    factor();

    /** Replace the right-hand side, this rank's entries in the order of the
     * numbering, by the solution. */
    void
    solve(std::vector<Number> &values);

    /** Operations of the last factorisation on all ranks. */
    double
    factor_flops() const;

    /** Entries of the factors on all ranks. */
    double
    factor_entries() const;

    /** What the last factorisation cost, in back substitutions. */
    double
    factor_cost() const;

  private:
    struct Instance;

    /** Announce a square matrix in the unknowns at @p places. */
    void
    add_pattern(const unsigned int *places, const unsigned int n);

    void
    run(const int job);

    /** Throw where run() has failed at @p what: ExcNotConverged for a singular
     * matrix, or ExcSolveFailed. Collective. */
    void
    check(const std::string &what) const;

    const MPI_Comm            comm;
    const bool                symmetric;
    const bool                compressed;
    const FreeNumbering      &numbering;
    std::unique_ptr<Instance> instance;
    std::size_t               next = 0;
    std::vector<int>          rows, columns;
    std::vector<Number>       entries;
    std::vector<Number>       centralised;
    std::vector<int>          counts, offsets;
  };
} // namespace lumbricus

#endif
