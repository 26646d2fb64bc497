// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_solvers_mumps_h
#define lumbricus_solvers_mumps_h

#include <lumbricus/core/state.h>

#include <deal.II/base/mpi.h>

#include <memory>
#include <vector>

namespace lumbricus
{
  /**
   * A factorisation by MUMPS (multifrontal, parallel): L D L^T of a symmetric
   * indefinite matrix or L U. Every rank hands over its own rows; the symbolic
   * analysis is done once for a pattern. All functions are collective.
   */
  class Mumps
  {
  public:
    Mumps(const MPI_Comm comm, const bool symmetric);
    ~Mumps();

    Mumps(const Mumps &) = delete;
    Mumps &
    operator=(const Mumps &) = delete;

    /**
     * Factor @p A, whose pattern is that of the first call. Throws
     * ExcNotConverged for a singular matrix, ExcSolveFailed when memory ends.
     */
    void
    factor(const Matrix &A);

    /** x = A^(-1) b with the factors there are. */
    void
    solve(Vector &x, const Vector &b);

    /** Memory of the factorisation on the rank that uses most [MB]. */
    int
    memory_in_megabytes() const;

  private:
    struct Instance;

    void
    run(const int job);

    /** Rows and columns of this rank's entries (lower triangle only where
     * symmetric), and the order of gathering their values. */
    void
    read_pattern(const Matrix &A);

    void
    read_values(const Matrix &A);

    const MPI_Comm            comm;
    const bool                symmetric;
    std::unique_ptr<Instance> instance;
    bool                      analysed = false;
    std::vector<int>          rows, columns;
    std::vector<double>       values;
    std::vector<double>       centralised;
    std::vector<int>          counts, offsets;
  };
} // namespace lumbricus

#endif
