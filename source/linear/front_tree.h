// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_linear_front_tree_h
#define lumbricus_linear_front_tree_h

#include <lumbricus/linear/division.h>
#include <lumbricus/linear/rank_tree.h>

#include <deal.II/base/mpi.h>

#include <array>
#include <memory>
#include <vector>

#include "rank_group.h"
#include "shared_front.h"

namespace lumbricus
{
  /**
   * The sum of dense matrices that ranks have in the unknowns that they share,
   * factored by the SharedFronts on the RankTree.
   *
   * The ranks that share a node all know the same of it. On the way up each
   * exchanges what is left with one of the other half; on the way down it tells
   * those that have a share of the node below only. Where a front is large each
   * computes some rows of its products, and they gather them, each way: one
   * call of at most RankTree::most_sharing ranks. A small one each has for itself,
   * which takes less time than to gather.
   */
  class FrontTree
  {
  public:
    /** With the unknowns @p shared of this rank; those of no cell have numbers
     * from @p first_more on; rows of fronts with @p least_shared entries or more
     * are shared; their matrix may be known to be @p symmetric. Collective, as are
     * factor() and solve(). */
    FrontTree(const RankTree                   &tree,
              const std::vector<SharedUnknown> &shared,
              const unsigned int                first_more,
              const double                      least_shared,
              const bool                        symmetric,
              const MPI_Comm                    comm);

    /** The most unknowns at a node with a share of this rank. */
    unsigned int
    largest_front() const;

    /** Entries that are kept, this rank's share. */
    double
    n_entries() const;

    /** Operations of a factorisation, this rank's share. */
    double
    flops() const;

    /** Factor, with this rank's @p matrix by rows.
     * @return whether the sum is regular as far as this rank knows. */
    bool
    factor(std::vector<float> matrix);

    /** Replace this rank's part @p of_shared of the right-hand side by the
     * solution. Of the unknowns that no cell has all ranks know the right-hand
     * side @p of_more; it becomes the solution in those that are eliminated here
     * and for which this rank speaks, 0 in others. */
    void
    solve(std::vector<float> &of_shared, std::vector<float> &of_more);

  private:
    /** A node at which this rank has a share. */
    struct Node
    {
      unsigned int              half;      ///< the one this rank is in
      unsigned int              across;    ///< who tells it what the other has
      std::vector<unsigned int> to_across; ///< those of the other that it tells
      std::vector<unsigned int> below;     ///< those that it tells the solution
      bool                      speaks;    ///< for all that share the node

      unsigned int                 n_ranks; ///< these
      std::unique_ptr<SharedFront> front;   ///< and this rank's share
      std::unique_ptr<RankGroup>   group;   ///< where rows are shared

      std::array<std::vector<float>, 2> of_halves; ///< right-hand sides
      std::vector<float>                all;       ///< their sum; the solution
      std::vector<float>                of_half;   ///< the solution, of own half
    };

    /** Make a node with what is @p left below, which is known to the ranks
     * @p sharing_below, of which this is number @p i; go to what is left then. */
    void
    add_node(const RankTree::Shared          &shared,
             const unsigned int               i,
             const std::vector<unsigned int> &sharing_below,
             std::vector<SharedUnknown>      &left);

    /** Tell the other half of a node these @p unknowns, and hear its. */
    std::vector<SharedUnknown>
    exchange(const Node                       &node,
             const std::vector<SharedUnknown> &unknowns) const;

    /** Let ranks that share rows have all of @p n entries of so many numbers. */
    static void
    gather(const Node        &node,
           float             *values,
           const unsigned int n,
           const unsigned int n_numbers = 1);

    /** Call a function with the entry in Node::all of each eliminated unknown that
     * no cell has, and which of these it is. */
    template <typename Function>
    void
    for_more(Node &node, const Function &function) const;

    const MPI_Comm     comm;
    const unsigned int rank;
    const unsigned int first_more;
    const double       least_shared;
    const bool         symmetric;
    std::vector<Node>  nodes; // from below
    unsigned int       n_left; // by all of them
    unsigned int       above;  // who tells their solution
  };
} // namespace lumbricus

#endif
