// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_divided_factor_h
#define lumbricus_linear_divided_factor_h

#include <lumbricus/linear/division.h>
#include <lumbricus/linear/free_numbering.h>
#include <lumbricus/linear/mumps.h>
#include <lumbricus/linear/rank_tree.h>

#include <deal.II/base/mpi.h>

#include <memory>
#include <optional>
#include <vector>

namespace lumbricus
{
  class FrontTree;



  /**
   * A factorisation in single precision of a sum of cells' matrices, in which
   * ranks talk about what they share and nothing else (substructuring). With the
   * unknowns i inside of rank r and those it shares, s,
   *
   *   S_r = A_ss - A_si A_ii^(-1) A_is
   *
   * is found by a Mumps of that rank alone, and the sum of all S_r is factored by
   * a FrontTree. To solve, each rank reduces its right-hand side, the tree is gone
   * up to its root and down again, and each rank finds what is inside.
   *
   * On one rank it is a Mumps. Where ranks share so much that dense matrices
   * would be larger than the factors of a body usually are, it is one Mumps on
   * all ranks.
   */
  class DividedFactor
  {
  public:
    /** No dense matrix has more entries than this, times the number of all
     * unknowns. */
    static constexpr double most_dense_entries = 500.;

    /** Where a node of the tree has so many entries or more, ranks share its
     * rows: a product with as many takes as long as two gatherings of eight
     * ranks, 15 us. */
    static constexpr double least_shared_entries = 1e5;

    /** For the unknowns in @p numbering, which is kept by reference, and the
     * pattern of Mumps::analyse(); with at most @p dense_entries times the number
     * of unknowns in a dense matrix, and shared rows from @p shared_entries on. Collective, as all functions are but the
     * additions. */
    DividedFactor(const MPI_Comm               comm,
                  const Mumps<float>::Options &options,
                  const CellUnknowns          &unknowns,
                  const unsigned int           n_left_out,
                  const FreeNumbering         &numbering,
                  const MoreEntries           &more,
                  const double dense_entries  = most_dense_entries,
                  const double shared_entries = least_shared_entries);

    ~DividedFactor();

    DividedFactor(const DividedFactor &) = delete;
    DividedFactor &
    operator=(const DividedFactor &) = delete;

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

    /** After all cells: add the entries of which the constructor had the
     * pattern. */
    void
    add(const MoreEntries &more);

    /** Factor the sum. Throws ExcNotConverged for a singular matrix where that is
     * found (MUMPS, where it leaves unknowns, does not find it always; then what
     * this is the preconditioner of does not converge), ExcSolveFailed when memory
     * ends. */
    void
    factor();

    /** Replace the right-hand side @p x, a vector with places for ghost entries
     * which is the sum of what ranks have at a place, by the solution, at all
     * places that owned cells have; and, on the first rank, the entries
     * @p more of the unknowns that no cell has. */
    void
    solve(Vector &x, std::vector<float> &more);

    /** What the last factorisation cost, in back substitutions. */
    double
    cost() const
    {
      return factor_cost;
    }

  private:
    /** Let the Mumps of this rank analyse what is inside. */
    void
    plan_inside(const Mumps<float>::Options &options,
                const CellUnknowns          &unknowns,
                const unsigned int           n_left_out,
                const MoreEntries           &more);

    /** The entries that this rank adds, by the numbers of its Mumps. */
    MoreEntries
    inside_entries(const MoreEntries &more) const;

    /** Factor the sum of what all ranks have left. */
    void
    factor_shared();

    /** As solve(), by one Mumps on all ranks. */
    void
    solve_undivided(Vector &x, std::vector<float> &more);

    const MPI_Comm       comm;
    const unsigned int   rank;
    const bool           symmetric;
    const RankTree       tree;
    const FreeNumbering &numbering;
    const unsigned int   n_more;
    const Division       division;
    bool                 is_divided;

    /** Of what this rank's Mumps has: the cells' unknowns, one that stands for
     * nothing, and those in Division::shared. */
    FreeNumbering                 inside_numbering;
    std::optional<unsigned int>   lonely;
    std::vector<unsigned int>     shared_numbers;
    std::unique_ptr<Mumps<float>> mumps;

    /** Where it is divided. */
    std::unique_ptr<FrontTree> fronts;

    std::vector<float> inside_values, of_shared;
    double             factor_cost = 0.;
  };
} // namespace lumbricus

#endif
