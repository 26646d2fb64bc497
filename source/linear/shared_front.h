// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_shared_front_h
#define lumbricus_linear_shared_front_h

#include <lumbricus/linear/division.h>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <vector>

#include "front_factors.h"
#include "rank_group.h"

namespace lumbricus
{
  /**
   * What is done at a node of the RankTree: the dense matrices of its halves, in
   * the unknowns that they have left, are added up, and what is shared by ranks
   * below only is eliminated,
   *
   *   [ F_ee  F_el ]
   *   [ F_le  F_ll ],   S = F_ll - P F_el,   P = F_le F_ee^(-1);
   *
   * S and the unknowns l that are left go to the node above. Several ranks do
   * that together. Each has the sum and the FrontFactors of F_ee, and computes some
   * rows of P, S, F_ee^(-1) and Q = F_ee^(-1) F_el. These are what right-hand sides
   * and solutions are multiplied by, so that of a solve each rank has its rows of
   * dense products.
   */
  class SharedFront
  {
  public:
    /** At @p node, with what its two halves have left, in ascending order; all
     * rows, until share(). */
    SharedFront(const unsigned int                               node,
                const std::array<std::vector<SharedUnknown>, 2> &halves);

    /** Keep the rows of number @p i of @p n ranks only. */
    void
    share(const unsigned int i, const unsigned int n);

    /** The numbers of the unknowns that are eliminated here, in the order in
     * which right-hand sides and solutions have them; those that are left
     * follow. */
    const std::vector<unsigned int> &
    eliminated() const
    {
      return eliminated_numbers;
    }

    /** The unknowns that are left. */
    const std::vector<SharedUnknown> &
    left() const
    {
      return left_unknowns;
    }

    /** The number of all of them. */
    unsigned int
    size() const
    {
      return eliminated_numbers.size() + left_unknowns.size();
    }

    /** Entries that are kept, of all rows. */
    double
    n_entries() const;

    /** Operations of a factorisation. */
    double
    flops() const;

    /** Factor the sum of the matrices of the @p halves, by rows, into this, and
     * make this rank's rows of @p left_matrix what is left; with the @p group of
     * the ranks that share it, if there is one.
     * @return whether it is regular. */
    bool
    factor(const std::array<std::vector<float>, 2> &halves,
           const bool                               symmetric,
           const RankGroup                         *group,
           std::vector<float>                      &left_matrix);

    /** The sum of the right-hand sides of the halves. */
    void
    sum(const std::array<std::vector<float>, 2> &halves,
        std::vector<float>                      &all) const;

    /** From a right-hand side @p all go to b_l - P b_e in this rank's part of
     * what is left. */
    void
    reduce(std::vector<float> &all);

    /** After reduce(), which others wait for: put F_ee^(-1) b_e into this rank's
     * part of what is eliminated. */
    void
    solve_eliminated(std::vector<float> &all);

    /** After that, with the solution x_l in what is left: subtract Q x_l there. */
    void
    expand(std::vector<float> &all);

    /** What of @p all half @p i has. */
    void
    extract(const unsigned int        i,
            const std::vector<float> &all,
            std::vector<float>       &of_half) const;

  private:
    /** Rows of P, F_ee^(-1) and Q, from what factor() has added up. */
    void
    compute_rows(const dealii::LAPACKFullMatrix<float> &lower,
                 const dealii::LAPACKFullMatrix<float> &upper,
                 std::vector<float>                    &left_matrix);

    std::vector<unsigned int>                eliminated_numbers;
    std::vector<SharedUnknown>               left_unknowns;
    std::array<std::vector<unsigned int>, 2> places; // of the halves', here
    PartOfList                               own_eliminated, own_left;

    /** Where two ranks share the root half of an inverse costs more than it
     * saves: both use the factors. */
    bool uses_factors = false;

    FrontFactors                    factors;      // of F_ee
    dealii::LAPACKFullMatrix<float> inverse_rows; // each a column
    dealii::LAPACKFullMatrix<float> up_rows;      // of P, each a column
    dealii::LAPACKFullMatrix<float> down_rows;    // of Q
    dealii::Vector<float>           of_eliminated, of_left;
    dealii::Vector<float>           of_own_eliminated, of_own_left;
  };
} // namespace lumbricus

#endif
