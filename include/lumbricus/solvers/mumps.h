// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_solvers_mumps_h
#define lumbricus_solvers_mumps_h

#include <lumbricus/solvers/free_numbering.h>

#include <deal.II/base/mpi.h>

#include <memory>
#include <vector>

namespace lumbricus
{
  /**
   * A factorisation by MUMPS (multifrontal, parallel): L D L^T of a symmetric
   * indefinite matrix or L U, in double or single precision (@p Number). Every
   * rank hands over the matrices of its own cells, which MUMPS adds up; the
   * symbolic analysis is done once for a pattern. All functions are
   * collective.
   */
  template <typename Number>
  class Mumps
  {
  public:
    struct Options
    {
      bool symmetric;
      /** Whether rows are exchanged for the sake of accuracy. */
      bool pivoting;
      /** Blocks far from the diagonal are compressed to low rank, up to this
       * error relative to the matrix; 0: not at all. */
      double compression;
    };

    Mumps(const MPI_Comm       comm,
          const Options       &options,
          const FreeNumbering &numbering);
    ~Mumps();

    Mumps(const Mumps &) = delete;
    Mumps &
    operator=(const Mumps &) = delete;

    /** Before the matrices of all cells are added. */
    void
    begin();

    /** Add a square matrix, by rows, in the unknowns at @p places. Always the
     * same ones, in the same order. */
    void
    add(const unsigned int *places, const unsigned int n, const double *matrix);

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

    /** Memory of the factorisation on the rank that uses most [MB]. */
    int
    memory_in_megabytes() const;

    /** Operations of the last factorisation on all ranks. */
    double
    factor_flops() const;

    /** Entries of the factors on all ranks. */
    double
    factor_entries() const;

  private:
    struct Instance;

    void
    run(const int job);

    void
    analyse();

    const MPI_Comm            comm;
    const bool                symmetric;
    const FreeNumbering      &numbering;
    std::unique_ptr<Instance> instance;
    bool                      analysed = false;
    std::size_t               next     = 0;
    std::vector<int>          rows, columns;
    std::vector<Number>       entries;
    std::vector<Number>       centralised;
    std::vector<int>          counts, offsets;
  };
} // namespace lumbricus

#endif
