// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_shared_front_h
#define lumbricus_linear_shared_front_h

#include <lumbricus/linear/division.h>

#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/vector.h>

#include <array>
#include <vector>

namespace lumbricus
{
  /**
   * What is done at a node of the RankTree: the dense matrices of its children, in
   * the unknowns that they have left, are added up, and what is shared by ranks
   * below only is eliminated with exchanges of rows,
   *
   *   [ F_ee  F_el ]
   *   [ F_le  F_ll ],   S = F_ll - F_le F_ee^(-1) F_el;
   *
   * S and the unknowns l that are left are the parent's.
   */
  class SharedFront
  {
  public:
    /** At @p node, with what its two children have left, in ascending order. */
    SharedFront(const unsigned int                              node,
                const std::array<std::vector<SharedUnknown>, 2> &children);

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

    /** Entries that a factorisation keeps. */
    double
    n_entries() const;

    /** Operations of a factorisation. */
    double
    flops() const;

    /** Factor the sum of the @p children 's matrices, by rows, into this, and make
     * @p left_matrix what is left.
     * @return whether it is regular. */
    bool
    factor(const std::array<std::vector<float>, 2> &children,
           std::vector<float>                      &left_matrix);

    /** The sum of the right-hand sides of the children. */
    void
    sum(const std::array<std::vector<float>, 2> &children,
        std::vector<float>                      &all) const;

    /** From a right-hand side @p all go to F_ee^(-1) b_e and
     * b_l - F_le F_ee^(-1) b_e. */
    void
    reduce(std::vector<float> &all);

    /** After reduce(): with the solution in what is left go to the one in all
     * unknowns. */
    void
    expand(std::vector<float> &all);

    /** What of @p all child @p i has. */
    void
    extract(const unsigned int        i,
            const std::vector<float> &all,
            std::vector<float>       &of_child) const;

  private:
    std::vector<unsigned int>                eliminated_numbers;
    std::vector<SharedUnknown>               left_unknowns;
    std::array<std::vector<unsigned int>, 2> places; // of the children's, here

    dealii::LAPACKFullMatrix<float> factors; // of F_ee
    dealii::LAPACKFullMatrix<float> lower;   // - F_le
    dealii::LAPACKFullMatrix<float> upper;   // - F_ee^(-1) F_el
    dealii::Vector<float>           of_eliminated, of_left;
  };
} // namespace lumbricus

#endif
