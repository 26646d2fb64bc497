// SPDX-License-Identifier: LGPL-2.1-or-later
#include "front_tree.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "tree_messages.h"

namespace lumbricus
{
  namespace
  {
    // Number and node, one after the other.
    std::vector<unsigned int>
    as_numbers(const std::vector<SharedUnknown> &unknowns)
    {
      std::vector<unsigned int> numbers;
      for (const SharedUnknown &unknown : unknowns)
        numbers.insert(numbers.end(), {unknown.number, unknown.node});
      return numbers;
    }



    std::vector<SharedUnknown>
    as_unknowns(const std::vector<unsigned int> &numbers)
    {
      std::vector<SharedUnknown> unknowns;
      for (unsigned int k = 0; k < numbers.size(); k += 2)
        unknowns.push_back({numbers[k], numbers[k + 1]});
      return unknowns;
    }



    // Of some ranks and the first few of them: who is told by number i of these
    // few, when they tell the others by turns.
    std::vector<unsigned int>
    told_by(const std::vector<unsigned int> &ranks,
            const unsigned int               first,
            const unsigned int               i,
            const unsigned int               n_telling)
    {
      std::vector<unsigned int> told;
      for (unsigned int k = first; k < ranks.size(); ++k)
        if (k % n_telling == i)
          told.push_back(ranks[k]);
      return told;
    }
  } // namespace



  FrontTree::FrontTree(const RankTree                   &tree,
                       const std::vector<SharedUnknown> &shared,
                       const unsigned int                first_more,
                       const double                      least_shared,
                       const bool                        symmetric,
                       const MPI_Comm                    comm)
    : comm(comm)
    , rank(dealii::Utilities::MPI::this_mpi_process(comm))
    , first_more(first_more)
    , least_shared(least_shared)
    , symmetric(symmetric)
  {
    std::vector<SharedUnknown> left = shared;
    std::vector<unsigned int>  sharing(1, rank); // of what is left
    unsigned int               i = 0;            // which of them this rank is
    for (const RankTree::Shared &node : tree.shared_by(rank))
      {
        add_node(node, i, sharing, left);
        sharing = node.halves[0];
        sharing.insert(sharing.end(),
                       node.halves[1].begin(),
                       node.halves[1].end());
        i = std::find(sharing.begin(), sharing.end(), rank) - sharing.begin();
      }
    n_left = left.size();
    above  = sharing[i % std::min<std::size_t>(sharing.size(),
                                              RankTree::most_sharing / 2)];
  }



  void
  FrontTree::add_node(const RankTree::Shared          &shared,
                      const unsigned int               i,
                      const std::vector<unsigned int> &sharing_below,
                      std::vector<SharedUnknown>      &left)
  {
    const auto &first = shared.halves[0];
    nodes.emplace_back();
    Node &node = nodes.back();
    node.half =
      std::find(first.begin(), first.end(), rank) == first.end() ? 1 : 0;
    const auto &own   = shared.halves[node.half];
    const auto &other = shared.halves[1 - node.half];
    node.across       = other[i % other.size()];
    node.to_across    = told_by(other, 0, i, own.size());
    node.below        = told_by(sharing_below, own.size(), i, own.size());

    std::array<std::vector<SharedUnknown>, 2> of_halves;
    of_halves[node.half]     = left;
    of_halves[1 - node.half] = exchange(node, left);
    for (unsigned int k = 0; k < 2; ++k)
      node.of_halves[k].resize(of_halves[k].size());

    std::vector<unsigned int> all = first;
    all.insert(all.end(), shared.halves[1].begin(), shared.halves[1].end());
    const unsigned int i_of_all =
      std::find(all.begin(), all.end(), rank) - all.begin();
    node.speaks  = i_of_all == 0;
    node.n_ranks = all.size();
    node.front   = std::make_unique<SharedFront>(shared.node, of_halves);
    if (node.front->n_entries() >= least_shared)
      {
        node.front->share(i_of_all, node.n_ranks);
        node.group = std::make_unique<RankGroup>(comm, all);
      }
    left = node.front->left();
  }



  std::vector<SharedUnknown>
  FrontTree::exchange(const Node                       &node,
                      const std::vector<SharedUnknown> &unknowns) const
  {
    const std::vector<unsigned int> numbers = as_numbers(unknowns);
    const std::vector<unsigned int> size(1, numbers.size());
    std::vector<unsigned int>       size_across(1);
    TreeMessages                    messages(comm);
    messages.send(size, node.to_across, TreeMessages::up);
    messages.send(numbers, node.to_across, TreeMessages::up);
    messages.receive(size_across, node.across, TreeMessages::up);
    std::vector<unsigned int> numbers_across(size_across[0]);
    messages.receive(numbers_across, node.across, TreeMessages::up);
    return as_unknowns(numbers_across);
  }



  unsigned int
  FrontTree::largest_front() const
  {
    unsigned int most = 0;
    for (const Node &node : nodes)
      most = std::max(most, node.front->size());
    return most;
  }



  double
  FrontTree::n_entries() const
  {
    double sum = 0.;
    for (const Node &node : nodes)
      sum += node.front->n_entries() / node.n_ranks;
    return sum;
  }



  double
  FrontTree::flops() const
  {
    double sum = 0.;
    for (const Node &node : nodes)
      sum += node.front->flops() / node.n_ranks;
    return sum;
  }



  bool
  FrontTree::factor(std::vector<float> matrix)
  {
    bool is_regular = true;
    for (Node &node : nodes)
      {
        std::array<std::vector<float>, 2> of_halves;
        {
          TreeMessages      messages(comm);
          const std::size_t n = node.of_halves[1 - node.half].size();
          messages.send(matrix, node.to_across, TreeMessages::up);
          of_halves[1 - node.half].resize(n * n);
          messages.receive(of_halves[1 - node.half],
                           node.across,
                           TreeMessages::up);
        }
        of_halves[node.half] = std::move(matrix);
        // What is wrong goes on to the end, where it is said.
        is_regular = node.front->factor(of_halves,
                                        symmetric,
                                        node.group.get(),
                                        matrix) &&
                     is_regular;
        const unsigned int n_left_here = node.front->left().size();
        gather(node, matrix.data(), n_left_here, n_left_here);
      }
    return is_regular;
  }



  void
  FrontTree::gather(const Node        &node,
                    float             *values,
                    const unsigned int n,
                    const unsigned int n_numbers)
  {
    if (node.group != nullptr)
      node.group->gather(values, n, n_numbers);
  }



  template <typename Function>
  void
  FrontTree::for_more(Node &node, const Function &function) const
  {
    const auto &eliminated = node.front->eliminated();
    for (unsigned int k = 0; k < eliminated.size(); ++k)
      if (eliminated[k] >= first_more)
        function(node.all[k], eliminated[k] - first_more);
  }



  void
  FrontTree::solve(std::vector<float> &of_shared, std::vector<float> &of_more)
  {
    TreeMessages messages(comm);
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        Node &node   = nodes[k];
        auto &of_own = node.of_halves[node.half];
        if (k == 0)
          of_own = of_shared;
        else
          of_own.assign(nodes[k - 1].all.begin() +
                          nodes[k - 1].front->eliminated().size(),
                        nodes[k - 1].all.end());
        messages.send(of_own, node.to_across, TreeMessages::up);
        messages.receive(node.of_halves[1 - node.half],
                         node.across,
                         TreeMessages::up);
        node.front->sum(node.of_halves, node.all);
        for_more(node, [&](float &entry, const unsigned int k_more) {
          entry += of_more[k_more];
        });
        node.front->reduce(node.all);
        gather(node,
               node.all.data() + node.front->eliminated().size(),
               node.front->left().size());
      }
    for (Node &node : nodes)
      node.front->solve_eliminated(node.all);

    std::fill(of_more.begin(), of_more.end(), 0.);
    std::vector<float> of_left(n_left);
    messages.receive(of_left, above, TreeMessages::down);
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node)
      {
        const unsigned int n = node->front->eliminated().size();
        std::copy(of_left.begin(), of_left.end(), node->all.begin() + n);
        node->front->expand(node->all);
        gather(*node, node->all.data(), n);
        if (node->speaks)
          for_more(*node, [&](float &entry, const unsigned int k_more) {
            of_more[k_more] = entry;
          });
        node->front->extract(node->half, node->all, node->of_half);
        messages.send(node->of_half, node->below, TreeMessages::down);
        of_left = node->of_half;
      }
    of_shared = of_left;
  }
} // namespace lumbricus
