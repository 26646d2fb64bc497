// SPDX-License-Identifier: LGPL-2.1-or-later
// A factorisation in which each rank eliminates what is inside of its part gives
// what one Mumps on all ranks gives in double precision: of symmetric matrices and
// others, with unknowns that no cell has on one rank and on several of them, on
// ranks that have nothing inside or no cells at all, and where ranks share too
// much.
#include <lumbricus/core/exceptions.h>
#include <lumbricus/linear/divided_factor.h>
#include <lumbricus/linear/rank_tree.h>

#include <deal.II/base/mpi.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "specimen.h"

using namespace lumbricus;

namespace
{
  // All ranks that share a node, those of the first half first.
  std::vector<unsigned int>
  all_of(const RankTree::Shared &node)
  {
    auto all = node.halves[0];
    all.insert(all.end(), node.halves[1].begin(), node.halves[1].end());
    return all;
  }



  TEST(RankTrees, ShareEveryNode)
  {
    for (unsigned int n = 1; n < 40; ++n)
      {
        const RankTree                                       tree(n);
        std::map<unsigned int, std::vector<RankTree::Shared>> by_node;
        unsigned int                                         depth = 0;
        for (unsigned int rank = 0; rank < n; ++rank)
          {
            std::vector<unsigned int> below(1, rank);
            const auto                nodes = tree.shared_by(rank);
            ASSERT_EQ(nodes.empty(), n == 1);
            depth = std::max<unsigned int>(depth, nodes.size());
            for (const RankTree::Shared &node : nodes)
              {
                by_node[node.node].push_back(node);
                const auto all  = all_of(node);
                const auto half = rank < node.node ? 0 : 1;
                const auto &own = node.halves[half];
                EXPECT_EQ(std::count(all.begin(), all.end(), rank), 1);
                EXPECT_EQ(std::count(own.begin(), own.end(), rank), 1);
                // As many as may be, the first of those that know what is left.
                ASSERT_EQ(own.size(),
                          std::min<std::size_t>(below.size(),
                                                RankTree::most_sharing / 2));
                EXPECT_TRUE(std::equal(own.begin(), own.end(), below.begin()));
                below = all;
              }
          }
        EXPECT_EQ(by_node.size(), n - 1);
        for (const auto &[node, of_ranks] : by_node)
          {
            EXPECT_EQ(of_ranks.size(), all_of(of_ranks[0]).size());
            EXPECT_GT(of_ranks.size(), 1u);
            for (const RankTree::Shared &of_rank : of_ranks)
              EXPECT_EQ(of_rank.halves, of_ranks[0].halves);
            for (const unsigned int first : of_ranks[0].halves[0])
              for (const unsigned int last : of_ranks[0].halves[1])
                EXPECT_EQ(tree.lowest_node(first, last), node);
          }
        unsigned int least_depth = 0;
        while ((1u << least_depth) < n)
          ++least_depth;
        // The rank with most of them need not be among the deepest.
        EXPECT_LE(depth, least_depth);
        EXPECT_GE(depth + 1, least_depth);
      }
  }



  TEST(RankTrees, KnowTheLowestNodeAboveSomeRanks)
  {
    const RankTree tree(7); // ((0, (1, 2)), ((3, 4), (5, 6)))
    EXPECT_EQ(tree.lowest_node(0, 0), RankTree::none);
    EXPECT_EQ(tree.lowest_node(6, 6), RankTree::none);
    EXPECT_EQ(tree.lowest_node(0, 1), 1u);
    EXPECT_EQ(tree.lowest_node(0, 2), 1u);
    EXPECT_EQ(tree.lowest_node(1, 2), 2u);
    EXPECT_EQ(tree.lowest_node(2, 3), 3u);
    EXPECT_EQ(tree.lowest_node(0, 6), 3u);
    EXPECT_EQ(tree.lowest_node(3, 4), 4u);
    EXPECT_EQ(tree.lowest_node(4, 5), 5u);
    EXPECT_EQ(tree.lowest_node(5, 6), 6u);
  }



  /** A body, and whether the matrix is symmetric. */
  struct Kind
  {
    const char *name;
    std::string body;
    bool        symmetric;
  };

  // Held, its sides and one end do not move.
  std::string
  block_of(const std::string &cells, const bool is_held)
  {
    std::string text = "subsection Geometry\n set Shape = block\n"
                       " subsection block\n  set Cells = " +
                       cells + "\n end\nend\n";
    if (is_held)
      {
        text += "subsection Boundary conditions\n set Names = a, b, c, d, e\n";
        for (const std::string name_and_face :
             {"ax max", "by min", "cy max", "dz min", "ez max"})
          text += " subsection " + name_and_face.substr(0, 1) +
                  "\n  set Boundary = " + name_and_face.substr(1) +
                  "\n  set Type = displacement\n end\n";
        text += "end\n";
      }
    return text;
  }

  class DividedFactors : public Specimen, public ::testing::TestWithParam<Kind>
  {
  public:
    static constexpr unsigned int n_private = CellUnknowns::n_private;
    static constexpr unsigned int n_more    = 5;

    DividedFactors()
      : Specimen(GetParam().body)
      , unknowns(model->assembler.tangent().unknowns)
      , numbering(unknowns, false, comm)
      , symmetric(GetParam().symmetric)
    {}

    // A matrix of a cell with a large diagonal, by its unknowns' numbers.
    std::vector<double>
    matrix(const unsigned int i) const
    {
      const auto          places = unknowns.free_unknowns(i);
      const unsigned int  n      = places.size() - n_private;
      std::vector<double> M(n * n);
      for (unsigned int r = 0; r < n; ++r)
        for (unsigned int s = 0; s < n; ++s)
          {
            const double a = numbering.number(places[n_private + r]);
            const double b = numbering.number(places[n_private + s]);
            M[r * n + s]   = std::sin(1. + .37 * (a + b)) + (r == s ? 200. : 0.);
            if (!symmetric)
              M[r * n + s] += std::sin(a - 2. * b);
            if (a == without_entries || b == without_entries)
              M[r * n + s] = 0.;
          }
      return M;
    }

    // Unknowns that no cell has: one that hangs together with all others, two
    // with few at either end, one with these two, and one with nothing.
    MoreEntries
    border() const
    {
      const unsigned int size = numbering.size();
      MoreEntries        more;
      more.n_unknowns = n_more;
      for (const unsigned int place : numbering.places())
        {
          const unsigned int number = numbering.number(place);
          const auto         add    = [&](const unsigned int k) {
            more.own.add(size + k, number, std::sin(3. + k + number));
            if (!symmetric)
              more.own.add(number, size + k, std::cos(3. + k + number));
          };
          add(0);
          if (number < 4)
            add(1);
          if (number + 4 >= size)
            add(2);
        }
      for (unsigned int k = 0; k < n_more; ++k)
        more.common.add(size + k, size + k, -20. - k);
      for (const auto &[k, l] : {std::make_pair(2u, 1u),
                                 std::make_pair(3u, 1u),
                                 std::make_pair(3u, 2u)})
        {
          more.common.add(size + k, size + l, 1. + k);
          if (!symmetric)
            more.common.add(size + l, size + k, 2. + l);
        }
      return more;
    }

    template <typename Factor>
    void
    factor(Factor &factors, const MoreEntries &more) const
    {
      factors.begin();
      for (unsigned int i = 0; i < unknowns.n_cells(); ++i)
        factors.add(unknowns.free_unknowns(i).size() - n_private,
                    matrix(i).data());
      factors.add(more);
      factors.factor();
    }

    void
    compare(const MoreEntries &more,
            const double dense_entries = DividedFactor::most_dense_entries,
            const double shared_entries = DividedFactor::least_shared_entries)
    {
      // Of the right-hand side every cell knows a part.
      Vector x, b;
      unknowns.reinit_vector(x);
      unknowns.reinit_vector(b);
      for (unsigned int i = 0; i < unknowns.n_cells(); ++i)
        {
          const auto places = unknowns.free_unknowns(i);
          for (unsigned int k = n_private; k < places.size(); ++k)
            x.local_element(places[k]) +=
              std::sin(1. + 12.9898 * numbering.number(places[k]));
        }
      b = 0.;
      for (unsigned int k = 0; k < b.get_partitioner()->locally_owned_size() +
                                     b.get_partitioner()->n_ghost_indices();
           ++k)
        b.local_element(k) = x.local_element(k);
      b.compress(dealii::VectorOperation::add);
      std::vector<double> values, of_more;
      if (dealii::Utilities::MPI::this_mpi_process(comm) == 0)
        for (unsigned int k = 0; k < more.n_unknowns; ++k)
          of_more.push_back(1. + k);
      std::vector<float> of_more_divided(of_more.begin(), of_more.end());
      numbering.extract(b, values);

      Mumps<double> mumps(comm, {symmetric, true, 0.}, numbering);
      mumps.analyse(unknowns, unknowns.n_cells(), n_private, more);
      factor(mumps, more);
      mumps.solve(values, of_more);

      DividedFactor divided(comm,
                            {symmetric, false, 0.},
                            unknowns,
                            n_private,
                            numbering,
                            more,
                            dense_entries,
                            shared_entries);
      factor(divided, more);
      divided.solve(x, of_more_divided);
      EXPECT_GT(divided.cost(), 0.);
      EXPECT_GT(divided.planned_flops(), 0.);

      double largest = 0.;
      for (const double value : values)
        largest = std::max(largest, std::abs(value));
      largest = dealii::Utilities::MPI::max(largest, comm);
      ASSERT_GT(largest, 0.);
      // Cells find the solution where they are, on any rank.
      b = 0.;
      numbering.insert(values, b);
      b.update_ghost_values();
      for (unsigned int i = 0; i < unknowns.n_cells(); ++i)
        {
          const auto places = unknowns.free_unknowns(i);
          for (unsigned int k = n_private; k < places.size(); ++k)
            ASSERT_NEAR(x.local_element(places[k]),
                        b.local_element(places[k]),
                        1e-5 * largest);
        }
      for (unsigned int k = 0; k < of_more.size(); ++k)
        EXPECT_NEAR(of_more_divided[k], of_more[k], 1e-5 * (1. + largest)) << k;
    }

    const CellUnknowns &unknowns;
    const FreeNumbering numbering;
    const bool          symmetric;
    double              without_entries = -1.; // the number of an unknown
  };

  INSTANTIATE_TEST_SUITE_P(
    Bodies,
    DividedFactors,
    ::testing::Values(Kind{"symmetric", block_of("5, 2, 1", false), true},
                      Kind{"general", block_of("5, 2, 1", false), false},
                      // Fronts of several block rows: positive definite ones, and
                      // with unknowns that no cell has others.
                      Kind{"much shared", block_of("2, 7, 7", false), true},
                      Kind{"alone", block_of("1, 1, 1", false), true},
                      Kind{"nothing inside", block_of("2, 1, 1", true), true},
                      Kind{"nothing inside, general",
                           block_of("2, 1, 1", true),
                           false}));



  TEST_P(DividedFactors, AreWhatOneMumpsIs)
  {
    compare({});
  }



  TEST_P(DividedFactors, HaveUnknownsThatNoCellHas)
  {
    compare(border());
  }



  TEST_P(DividedFactors, ShareTheRowsOfFronts)
  {
    compare({}, DividedFactor::most_dense_entries, 0.);
    compare(border(), DividedFactor::most_dense_entries, 0.);
  }



  TEST_P(DividedFactors, AreNotDividedWhereRanksShareTooMuch)
  {
    compare(border(), 0.);
  }



  // What the rank at the root of the tree finds all of them say.
  TEST_P(DividedFactors, SayThatAMatrixIsSingular)
  {
    MoreEntries more = border();
    for (MatrixEntries *entries : {&more.own, &more.common})
      for (unsigned int e = 0; e < entries->rows.size(); ++e)
        if (entries->rows[e] == numbering.size() ||
            entries->columns[e] == numbering.size())
          entries->values[e] = 0.;
    DividedFactor factors(comm,
                          {symmetric, false, 0.},
                          unknowns,
                          n_private,
                          numbering,
                          more);
    EXPECT_THROW(factor(factors, more), ExcNotConverged);
  }



  // What a rank finds inside of its part all of them say. Where unknowns are left
  // MUMPS does not find all, and puts another pivot in place of one that is zero:
  // the solution is a number, and what it is the preconditioner of does not
  // converge.
  TEST_P(DividedFactors, MaySayThatAMatrixIsSingularInside)
  {
    for (const bool pivoting : {false, true})
      for (without_entries = 0.; without_entries < numbering.size();
           without_entries += numbering.size() / 3 + 1)
        {
          DividedFactor factors(comm,
                                {symmetric, pivoting, 0.},
                                unknowns,
                                n_private,
                                numbering,
                                {});
          double is_said = 0.;
          try
            {
              factor(factors, {});
            }
          catch (const ExcNotConverged &)
            {
              is_said = 1.;
            }
          const auto of_ranks =
            dealii::Utilities::MPI::min_max_avg(is_said, comm);
          EXPECT_EQ(of_ranks.min, of_ranks.max);
          if (dealii::Utilities::MPI::n_mpi_processes(comm) == 1)
            {
              EXPECT_EQ(is_said, 1.);
            }
          if (is_said > 0.)
            continue;
          Vector             x;
          std::vector<float> none;
          unknowns.reinit_vector(x);
          x = 1.;
          factors.solve(x, none);
          EXPECT_TRUE(std::isfinite(x.l2_norm()));
        }
  }
} // namespace
