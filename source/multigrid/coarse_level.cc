// SPDX-License-Identifier: LGPL-2.1-or-later
#include "coarse_level.h"

#include <lumbricus/constraints/local_constraints.h>
#include <lumbricus/discretization/cell_sizes.h>

#include <deal.II/base/config.h>
#include <deal.II/base/exceptions.h>
#include <deal.II/base/geometry_info.h>
#include <deal.II/base/mpi.h>

#include <algorithm>
#include <set>

namespace lumbricus
{
  namespace
  {
    using Index = dealii::types::global_dof_index;
    using cell_sizes::n_per_cell;

    class LevelMaker
    {
    public:
      LevelMaker(const MixedSpace               &space,
                 const CellUnknowns             &fine,
                 const std::vector<CellLineage> &cells,
                 const SplitCells               &ranks,
                 const unsigned int              l)
        : space(space)
        , fine(fine)
        , cells(cells)
        , ranks(ranks)
        , l(l)
        , comm(space.communicator())
        , me(dealii::Utilities::MPI::this_mpi_process(comm))
      {
        fine.reinit_vector(numbers);
      }

      CoarseLevel
      make()
      {
        list_cells();
        number();
        read_cells();
        exchange();

        std::vector<Index> known = of_cells;
        for (const auto &[line, entries] : constrained)
          {
            known.push_back(line);
            // Beyond the interface, which the rank may have no cell of.
            for (const auto &entry : entries)
              known.push_back(entry.first);
          }
        std::sort(known.begin(), known.end());
        AssertThrow(known.empty() || known.back() < n_unknowns,
                    dealii::ExcInternalError());
        dealii::IndexSet owned(n_unknowns);
        owned.add_range(first, first + n_owned);
        dealii::IndexSet lines = owned;
        lines.add_indices(known.begin(), known.end());
        lines.compress();
        auto constraints = local_constraints(owned, lines);
        for (const auto &[line, entries] : constrained)
          {
            constraints.add_line(line);
            for (const auto &[target, weight] : entries)
              constraints.add_entry(line, target, weight);
          }

        level.own = std::make_unique<CellUnknowns>(space);
        level.own->reinit(owned, of_cells, constraints);
        level.unknowns   = level.own.get();
        level.n_unknowns = n_unknowns;
        return {std::move(level), std::move(index_of)};
      }

    private:
      const CellKey &
      key_of(const CellLineage &cell) const
      {
        return cell.keys[std::min(l, cell.level())];
      }

      // Call function(unknown of the cell on this level, place on the active
      // cell) for the displacements that active cell i knows.
      template <typename Function>
      void
      for_each_displacement(const unsigned int i,
                            const Function    &function) const
      {
        constexpr unsigned int n_vertices =
          dealii::GeometryInfo<dim>::vertices_per_cell;
        const bool same = cells[i].level() <= l;
        for (unsigned int n = 0; n < (same ? MixedSpace::n_nodes : n_vertices);
             ++n)
          {
            const int node = same ? n : node_of_ancestor(cells[i], l, n);
            if (node >= 0)
              for (unsigned int c = 0; c < dim; ++c)
                function(CellUnknowns::displacement(c, node),
                         CellUnknowns::displacement(c, n));
          }
      }

      // The owned cells, then those of which others own a part and the cell.
      void
      list_cells()
      {
        std::set<CellKey>                             seen;
        std::vector<std::pair<CellKey, unsigned int>> foreign;
        for (const CellLineage &cell : cells)
          {
            const CellKey &key = key_of(cell);
            if (!seen.insert(key).second)
              continue;
            const auto split = ranks.find(key);
            if (split != ranks.end() && split->second.front() != me)
              foreign.emplace_back(key, split->second.front());
            else
              index_of.emplace(key, index_of.size());
          }
        level.n_owned_cells = index_of.size();
        for (const auto &[key, owner] : foreign)
          {
            index_of.emplace(key, index_of.size());
            level.owner.push_back(owner);
          }
        level.n_cells = index_of.size();

        unsigned int split_number = 0;
        level.split_number.resize(level.owner.size());
        for (const auto &[key, sharers] : ranks)
          {
            const auto found = index_of.find(key);
            if (found != index_of.end())
              {
                const unsigned int i = found->second;
                if (i < level.n_owned_cells)
                  level.split_cells.emplace_back(split_number, i);
                else
                  level.split_number[i - level.n_owned_cells] = split_number;
              }
            ++split_number;
          }
      }

      // Displacements belong to the rank that owns them on the finest mesh,
      // pressures to that of the cell.
      void
      number()
      {
        for (unsigned int i = 0; i < cells.size(); ++i)
          for_each_displacement(i,
                                [&](const unsigned int, const unsigned int k) {
                                  numbers.local_element(fine.places(i)[k]) = 1.;
                                });
        numbers.compress(dealii::VectorOperation::add);
        const unsigned int n_fine =
          numbers.get_partitioner()->locally_owned_size();
        n_owned = 0;
        for (unsigned int k = 0; k < n_fine; ++k)
          if (numbers.local_element(k) > 0.)
            level.on_finest.push_back(k);
        n_owned                     = level.on_finest.size();
        const Index n_displacements = n_owned;
        n_owned += MixedSpace::n_pressure_modes * level.n_owned_cells;
        level.on_finest.resize(n_owned, dealii::numbers::invalid_unsigned_int);
        MPI_Exscan(
          &n_owned, &first, 1, DEAL_II_DOF_INDEX_MPI_TYPE, MPI_SUM, comm);
        n_unknowns = dealii::Utilities::MPI::sum(n_owned, comm);

        Index next = first;
        for (unsigned int k = 0; k < n_fine; ++k)
          numbers.local_element(k) =
            numbers.local_element(k) > 0. ? next++ : -1.;
        numbers.update_ghost_values();
        first_pressure = first + n_displacements;
      }

      Index
      number_at(const unsigned int place) const
      {
        const double number = numbers.local_element(place);
        AssertThrow(number >= 0., dealii::ExcInternalError());
        return static_cast<Index>(number + 0.5);
      }

      void
      read_cells()
      {
        of_cells.assign(std::size_t(level.n_cells) * n_per_cell,
                        dealii::numbers::invalid_dof_index);
        for (unsigned int i = 0; i < cells.size(); ++i)
          {
            Index *const of_cell = indices(index_of.at(key_of(cells[i])));
            for_each_displacement(
              i, [&](const unsigned int k, const unsigned int on_active) {
                of_cell[k] = number_at(fine.places(i)[on_active]);
                if (!fine.is_constrained(i, on_active) ||
                    constrained.count(of_cell[k]) > 0)
                  return;
                auto &entries = constrained[of_cell[k]];
                for (const auto &[place, weight] : fine.row(i, on_active))
                  entries.emplace_back(number_at(place), weight);
              });
          }
        for (unsigned int i = 0; i < level.n_owned_cells; ++i)
          for (unsigned int m = 0; m < MixedSpace::n_pressure_modes; ++m)
            indices(i)[CellUnknowns::pressure(m)] =
              first_pressure + i * MixedSpace::n_pressure_modes + m;
      }

      // Each rank that owns a part of a cell tells the others what it knows:
      // of each unknown the place on the cell, the number, and how many
      // entries its constraint has, -1 if none, followed by these.
      void
      exchange()
      {
        std::map<unsigned int, std::vector<double>> send;
        unsigned int                                split_number = 0;
        for (const auto &[key, sharers] : ranks)
          {
            const auto found = index_of.find(key);
            if (found != index_of.end())
              {
                std::vector<double> message;
                const Index        *of_cell = indices(found->second);
                for (unsigned int k = 0; k < n_per_cell; ++k)
                  if (of_cell[k] != dealii::numbers::invalid_dof_index)
                    {
                      const auto line = constrained.find(of_cell[k]);
                      const bool held = line != constrained.end();
                      message.insert(message.end(),
                                     {double(split_number),
                                      double(k),
                                      double(of_cell[k]),
                                      held ? double(line->second.size()) :
                                             -1.});
                      if (held)
                        for (const auto &[target, weight] : line->second)
                          message.insert(message.end(),
                                         {double(target), weight});
                    }
                for (const unsigned int rank : sharers)
                  if (rank != me)
                    send[rank].insert(send[rank].end(),
                                      message.begin(),
                                      message.end());
              }
            ++split_number;
          }

        std::vector<int> cell_with(split_number, -1);
        split_number = 0;
        for (const auto &[key, sharers] : ranks)
          {
            const auto found = index_of.find(key);
            if (found != index_of.end())
              cell_with[split_number] = found->second;
            ++split_number;
          }
        for (const auto &[rank, message] :
             dealii::Utilities::MPI::some_to_some(comm, send))
          for (auto at = message.begin(); at != message.end();)
            {
              const auto i             = static_cast<unsigned int>(*at++);
              const auto k             = static_cast<unsigned int>(*at++);
              const auto index         = static_cast<Index>(*at++);
              const int  n_entries     = static_cast<int>(*at++);
              indices(cell_with[i])[k] = index;
              if (n_entries < 0)
                continue;
              auto &entries = constrained[index];
              entries.clear();
              for (int e = 0; e < n_entries; ++e, at += 2)
                entries.emplace_back(static_cast<Index>(at[0]), at[1]);
            }
      }

      Index *
      indices(const unsigned int i)
      {
        return of_cells.data() + std::size_t(i) * n_per_cell;
      }

      const MixedSpace               &space;
      const CellUnknowns             &fine;
      const std::vector<CellLineage> &cells;
      const SplitCells               &ranks;
      const unsigned int              l;
      const MPI_Comm                  comm;
      const unsigned int              me;

      Level                           level;
      std::map<CellKey, unsigned int> index_of;
      /** Of each unknown on the finest mesh the number on this one, or -1. */
      Vector             numbers;
      Index              n_owned = 0, first = 0, n_unknowns = 0;
      Index              first_pressure = 0;
      std::vector<Index> of_cells;
      std::map<Index, std::vector<std::pair<Index, double>>> constrained;
    };
  } // namespace



  CoarseLevel
  make_coarse_level(const MixedSpace               &space,
                    const CellUnknowns             &unknowns,
                    const std::vector<CellLineage> &cells,
                    const SplitCells               &split,
                    const unsigned int              l)
  {
    return LevelMaker(space, unknowns, cells, split, l).make();
  }
} // namespace lumbricus
