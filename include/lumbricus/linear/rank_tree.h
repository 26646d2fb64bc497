// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_rank_tree_h
#define lumbricus_linear_rank_tree_h

#include <array>

namespace lumbricus
{
  /**
   * All ranks, halved again and again until each is alone: a binary tree with
   * the ranks as leaves. Each of its nodes is the first rank of its second half;
   * every rank but 0 is so just one node, for which it does the work, and the
   * depth is the logarithm of the number of ranks. Ranks that follow each other
   * have neighbouring parts of the mesh.
   */
  class RankTree
  {
  public:
    /** No node. */
    static constexpr unsigned int none = static_cast<unsigned int>(-1);

    /** For so many ranks, one or more. */
    explicit RankTree(const unsigned int n_ranks)
      : n_ranks(n_ranks)
    {}

    /** The lowest node above all ranks from @p first to @p last; none where that
     * is one rank. */
    unsigned int
    lowest_node(const unsigned int first, const unsigned int last) const;

    /** The node above a rank; none where there is one rank only. */
    unsigned int
    parent_of_rank(const unsigned int rank) const;

    /** The node above a node; none where that is the root. */
    unsigned int
    parent_of_node(const unsigned int node) const;

    /** The ranks that do the work for what is below a node: a rank itself
     * where a half is one rank. */
    std::array<unsigned int, 2>
    children(const unsigned int node) const;

  private:
    /** The ranks first, ..., end - 1. */
    struct Range
    {
      unsigned int first, end;

      /** The node that halves them. */
      unsigned int
      node() const
      {
        return first + (end - first) / 2;
      }

      /** Keep the half with a rank. */
      void
      halve(const unsigned int rank)
      {
        (rank < node() ? end : first) = node();
      }
    };

    const unsigned int n_ranks;
  };
} // namespace lumbricus

#endif
