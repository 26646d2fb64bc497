// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/linear/rank_tree.h>

#include <algorithm>

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



  RankTree::Shared
  RankTree::sharing(const Range &range)
  {
    Shared result{range.node(), {}};
    for (unsigned int i = 0; i < 2; ++i)
      {
        const Range half =
          i == 0 ? Range{range.first, range.node()} : Range{range.node(), range.end};
        auto &of_half = result.halves[i];
        if (half.end - half.first == 1)
          of_half.push_back(half.first);
        else
          for (const auto &quarter : sharing(half).halves)
            of_half.insert(of_half.end(), quarter.begin(), quarter.end());
        if (of_half.size() > most_sharing / 2)
          of_half.resize(most_sharing / 2);
      }
    return result;
  }



  std::vector<RankTree::Shared>
  RankTree::shared_by(const unsigned int rank) const
  {
    std::vector<Shared> nodes;
    for (Range range{0, n_ranks}; range.end - range.first > 1; range.halve(rank))
      {
        nodes.push_back(sharing(range));
        bool is_there = false;
        for (const auto &half : nodes.back().halves)
          is_there |= std::find(half.begin(), half.end(), rank) != half.end();
        if (!is_there)
          nodes.pop_back();
      }
    std::reverse(nodes.begin(), nodes.end());
    return nodes;
  }
} // namespace lumbricus
