// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/linear/rank_tree.h>

namespace lumbricus
{
  unsigned int
  RankTree::lowest_node(const unsigned int first, const unsigned int last) const
  {
    Range range{0, n_ranks};
    while (range.end - range.first > 1)
      {
        if (first < range.node() && last >= range.node())
          return range.node();
        range.halve(first);
      }
    return none;
  }



  unsigned int
  RankTree::parent_of_rank(const unsigned int rank) const
  {
    unsigned int parent = none;
    for (Range range{0, n_ranks}; range.end - range.first > 1; range.halve(rank))
      parent = range.node();
    return parent;
  }



  unsigned int
  RankTree::parent_of_node(const unsigned int node) const
  {
    unsigned int parent = none;
    for (Range range{0, n_ranks}; range.node() != node; range.halve(node))
      parent = range.node();
    return parent;
  }



  std::array<unsigned int, 2>
  RankTree::children(const unsigned int node) const
  {
    Range range{0, n_ranks};
    while (range.node() != node)
      range.halve(node);
    // What halves a single rank is that rank.
    return {{Range{range.first, node}.node(), Range{node, range.end}.node()}};
  }
} // namespace lumbricus
