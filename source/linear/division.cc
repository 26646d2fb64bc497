// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/linear/division.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <set>
#include <utility>

namespace lumbricus
{
  namespace
  {
    // The first and the last rank that has to do with an unknown.
    struct Ranks
    {
      unsigned int first, last;

      void
      extend(const Ranks &other)
      {
        first = std::min(first, other.first);
        last  = std::max(last, other.last);
      }
    };



    // The ranks of the unknown at every place of a vector: those that own it or
    // have a cell with it. Nothing for what is at no cell and has no number.
    class RanksOfPlaces
    {
    public:
      RanksOfPlaces(const CellUnknowns  &unknowns,
                    const unsigned int   n_left_out,
                    const FreeNumbering &numbering,
                    const MPI_Comm       comm)
        : n_ranks(dealii::Utilities::MPI::n_mpi_processes(comm))
      {
        const unsigned int rank =
          dealii::Utilities::MPI::this_mpi_process(comm);
        // The largest of what ranks say is found where vectors are compressed;
        // 0 is that of who says nothing.
        for (Vector *vector : {&from_end, &from_begin})
          unknowns.reinit_vector(*vector);
        const auto is_here = [&](const unsigned int place) {
          from_end.local_element(place)   = n_ranks - rank;
          from_begin.local_element(place) = rank + 1;
        };
        for (const unsigned int place : numbering.places())
          is_here(place);
        for (unsigned int i = 0; i < unknowns.n_cells(); ++i)
          {
            const auto places = unknowns.free_unknowns(i);
            for (unsigned int k = n_left_out; k < places.size(); ++k)
              {
                is_here(places[k]);
                at_cells.push_back(places[k]);
              }
          }
        for (Vector *vector : {&from_end, &from_begin})
          {
            vector->compress(dealii::VectorOperation::max);
            vector->update_ghost_values();
          }
        at_cells.insert(at_cells.end(),
                        numbering.places().begin(),
                        numbering.places().end());
        std::sort(at_cells.begin(), at_cells.end());
        at_cells.erase(std::unique(at_cells.begin(), at_cells.end()),
                       at_cells.end());
      }

      Ranks
      operator[](const unsigned int place) const
      {
        return {n_ranks - static_cast<unsigned int>(
                            from_end.local_element(place) + 0.5),
                static_cast<unsigned int>(from_begin.local_element(place) +
                                          0.5) -
                  1};
      }

      // All places that this rank owns or has a cell with.
      const std::vector<unsigned int> &
      places() const
      {
        return at_cells;
      }

    private:
      const unsigned int        n_ranks;
      Vector                    from_end, from_begin;
      std::vector<unsigned int> at_cells;
    };



    // Whether the node of some ranks is the one above all of theirs and others.
    bool
    is_above(const Ranks &ranks, const Ranks &others, const RankTree &tree)
    {
      Ranks both = ranks;
      both.extend(others);
      return tree.lowest_node(both.first, both.last) ==
             tree.lowest_node(ranks.first, ranks.last);
    }



    // The ranks of each unknown that no cell has: those of its neighbours.
    std::vector<Ranks>
    ranks_of_more(const RanksOfPlaces &ranks,
                  const FreeNumbering &numbering,
                  const MoreEntries   &more,
                  const RankTree      &tree,
                  const MPI_Comm       comm)
    {
      const unsigned int n     = numbering.size();
      const unsigned int first = numbering.places().empty() ?
                                   0 :
                                   numbering.number(numbering.places()[0]);
      const unsigned int n_ranks =
        dealii::Utilities::MPI::n_mpi_processes(comm);

      // The least and the largest, as above.
      std::vector<unsigned int> from_end(more.n_unknowns, 0);
      std::vector<unsigned int> from_begin(more.n_unknowns, 0);
      for (unsigned int k = 0; k < more.own.rows.size(); ++k)
        for (const auto &[global, other] :
             {std::make_pair(more.own.rows[k], more.own.columns[k]),
              std::make_pair(more.own.columns[k], more.own.rows[k])})
          if (global >= n && other < n)
            {
              AssertIndexRange(other - first, numbering.n_owned());
              const Ranks of = ranks[numbering.places()[other - first]];
              from_end[global - n] =
                std::max(from_end[global - n], n_ranks - of.first);
              from_begin[global - n] =
                std::max(from_begin[global - n], of.last + 1);
            }
      dealii::Utilities::MPI::max(from_end, comm, from_end);
      dealii::Utilities::MPI::max(from_begin, comm, from_begin);
      std::vector<Ranks> found;
      for (unsigned int k = 0; k < more.n_unknowns; ++k)
        if (from_begin[k] > 0)
          found.push_back({n_ranks - from_end[k], from_begin[k] - 1});
        else
          found.push_back({0, 0});

      // Of two neighbours one has to come after the other: their nodes must be
      // on one way to the root.
      for (bool changed = true; changed;)
        {
          changed = false;
          for (unsigned int k = 0; k < more.common.rows.size(); ++k)
            {
              const auto [one, other] =
                std::minmax(more.common.rows[k], more.common.columns[k]);
              const Ranks &of_one   = found[one - n];
              Ranks       &of_other = found[other - n];
              if (!is_above(of_one, of_other, tree) &&
                  !is_above(of_other, of_one, tree))
                {
                  of_other.extend(of_one);
                  changed = true;
                }
            }
        }
      return found;
    }
  } // namespace



  Division::Division(const CellUnknowns  &unknowns,
                     const unsigned int   n_left_out,
                     const FreeNumbering &numbering,
                     const MoreEntries   &more,
                     const RankTree      &tree,
                     const MPI_Comm       comm)
  {
    const unsigned int n    = numbering.size();
    const unsigned int rank = dealii::Utilities::MPI::this_mpi_process(comm);
    const RanksOfPlaces ranks(unknowns, n_left_out, numbering, comm);
    std::vector<std::pair<SharedUnknown, unsigned int>> with_places;
    for (const unsigned int place : ranks.places())
      {
        const Ranks of = ranks[place];
        if (of.first == of.last)
          inside.push_back(place);
        else
          with_places.push_back({{numbering.number(place),
                                  tree.lowest_node(of.first, of.last)},
                                 place});
      }
    std::sort(with_places.begin(),
              with_places.end(),
              [](const auto &a, const auto &b) {
                return a.first.number < b.first.number;
              });
    for (const auto &[unknown, place] : with_places)
      {
        shared.push_back(unknown);
        shared_places.push_back(place);
      }

    const auto of_more = ranks_of_more(ranks, numbering, more, tree, comm);
    std::set<unsigned int> met;
    for (const auto *indices : {&more.own.rows, &more.own.columns})
      for (const unsigned int index : *indices)
        if (index >= n)
          met.insert(index - n);
    for (unsigned int k = 0; k < more.common.rows.size(); ++k)
      {
        // It goes to a rank below the nodes of both, one of which is above the
        // other.
        const unsigned int row    = more.common.rows[k] - n;
        const unsigned int column = more.common.columns[k] - n;
        const unsigned int lower =
          is_above(of_more[row], of_more[column], tree) ? column : row;
        if (of_more[lower].first == rank)
          {
            common_entries.push_back(k);
            met.insert(row);
            met.insert(column);
          }
      }
    for (const unsigned int k : met)
      {
        const Ranks of = of_more[k];
        if (of.first != of.last)
          shared.push_back({n + k, tree.lowest_node(of.first, of.last)});
        else if (of.first == rank)
          more_inside.push_back(k);
      }
  }
} // namespace lumbricus
