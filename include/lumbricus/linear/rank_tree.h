// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_rank_tree_h
#define lumbricus_linear_rank_tree_h

#include <array>
#include <vector>

namespace lumbricus
{
  /**
   * All ranks, halved again and again until each is alone: a binary tree with
   * the ranks as leaves. Each of its nodes has the number of the first rank of its
   * second half; the depth is the logarithm of the number of ranks. Ranks that
   * follow each other have neighbouring parts of the mesh.
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

    /** What is done at a node is shared by at most this number of ranks. */
    static constexpr unsigned int most_sharing = 8;

    /** A node, and the ranks that share what is done at it, by the halves that
     * they are in. Each of them has a share of what is done at the node below,
     * or is that rank: it is one of the first there. */
    struct Shared
    {
      unsigned int                             node;   ///< its number
      std::array<std::vector<unsigned int>, 2> halves; ///< ranks, ascending
    };

    /** The nodes at which a rank has a share, from below. With the one that
     * halves two ranks each begins; at the root some end. */
    std::vector<Shared>
    shared_by(const unsigned int rank) const;

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

    /** Who shares what is done at the node of some ranks. */
    static Shared
    sharing(const Range &range);

    const unsigned int n_ranks;
  };
} // namespace lumbricus

#endif
