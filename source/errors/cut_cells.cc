// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/adaptivity/family_transfer.h>
#include <lumbricus/adaptivity/state_transfer.h>
#include <lumbricus/discretization/cell_state.h>
#include <lumbricus/errors/cut_cells.h>

#include <deal.II/base/mpi.h>
#include <deal.II/grid/cell_id.h>

#include <algorithm>
#include <cmath>

namespace lumbricus
{
  namespace
  {
    constexpr unsigned int n_per_cell = CellUnknowns::n_per_cell;

    // Copy so many numbers from one place to another.
    void
    copy(const std::vector<double> &from,
         const unsigned int         i,
         std::vector<double>       &to,
         const unsigned int         k,
         const unsigned int         width)
    {
      std::copy_n(from.begin() + std::size_t(i) * width,
                  width,
                  to.begin() + std::size_t(k) * width);
    }



    // Send the numbers of cells to other ranks, and write those that come.
    template <typename OfRanks>
    void
    exchange(const MPI_Comm             comm,
             const std::vector<double> &from,
             const OfRanks             &sent,
             const OfRanks             &received,
             const unsigned int         width,
             std::vector<double>       &to)
    {
      std::map<unsigned int, std::vector<double>> messages;
      for (const auto &[rank, cells] : sent)
        {
          auto &message = messages[rank];
          message.resize(cells.size() * width);
          for (unsigned int k = 0; k < cells.size(); ++k)
            copy(from, cells[k], message, k, width);
        }
      const auto come = dealii::Utilities::MPI::some_to_some(comm, messages);
      for (const auto &[rank, cells] : received)
        for (unsigned int k = 0; k < cells.size(); ++k)
          copy(come.at(rank), k, to, cells[k], width);
    }
  } // namespace



  CutCells::CutCells(const Body         &large,
                     const CellUnknowns &large_unknowns,
                     const Body         &small,
                     const CellUnknowns &small_unknowns)
    : large(large)
    , small(small)
    , large_unknowns(large_unknowns)
    , small_unknowns(small_unknowns)
  {
    std::map<dealii::CellId, unsigned int> owned, families;
    for (const OwnedCell cell : large.owned_cells())
      owned[cell.iterator->id()] = cell.index;
    std::vector<dealii::CellId> wanted;
    std::vector<unsigned int>   wanted_families;
    for (const OwnedCell cell : small.owned_cells())
      {
        const auto parent = cell.iterator->parent();
        const auto family = families.emplace(parent->id(), families.size());
        if (family.second)
          {
            const auto parent_here = owned.find(parent->id());
            if (parent_here != owned.end())
              here.emplace_back(family.first->second, parent_here->second);
            else
              {
                wanted.push_back(parent->id());
                wanted_families.push_back(family.first->second);
              }
          }
        unsigned int child = 0;
        while (parent->child(child)->index() != cell.iterator->index())
          ++child;
        members.push_back({family.first->second, child});
      }
    n_families = families.size();

    // Each rank tells all what it wants; whoever has it says so.
    const MPI_Comm     comm = large.space.communicator();
    const unsigned int me   = dealii::Utilities::MPI::this_mpi_process(comm);
    std::vector<dealii::CellId::binary_type> ids;
    for (const dealii::CellId &id : wanted)
      ids.push_back(id.to_binary<dim>());
    const auto of_ranks = dealii::Utilities::MPI::all_gather(comm, ids);
    std::map<unsigned int, std::vector<unsigned int>> answers;
    for (unsigned int rank = 0; rank < of_ranks.size(); ++rank)
      for (unsigned int k = 0; k < of_ranks[rank].size() && rank != me; ++k)
        {
          const auto found = owned.find(dealii::CellId(of_ranks[rank][k]));
          if (found == owned.end())
            continue;
          large_for[rank].push_back(found->second);
          answers[rank].push_back(k);
        }
    for (const auto &[rank, places] :
         dealii::Utilities::MPI::some_to_some(comm, answers))
      for (const unsigned int k : places)
        from[rank].push_back(wanted_families[k]);

    small_unknowns.reinit_vector(shares);
    for (unsigned int i = 0; i < members.size(); ++i)
      for (unsigned int k = 0; k < n_per_cell; ++k)
        shares.local_element(small_unknowns.places(i)[k]) += 1.;
    shares.compress(dealii::VectorOperation::add);
    for (double &share : shares)
      share = 1. / share;
    shares.update_ghost_values();
  }



  std::vector<double>
  CutCells::to_families(const std::vector<double> &of_large,
                        const unsigned int         width) const
  {
    std::vector<double> result(std::size_t(n_families) * width);
    for (const auto &[family, cell] : here)
      copy(of_large, cell, result, family, width);
    exchange(large.space.communicator(),
             of_large,
             large_for,
             from,
             width,
             result);
    return result;
  }



  std::vector<double>
  CutCells::to_large(const std::vector<double> &of_families,
                     const unsigned int         width) const
  {
    std::vector<double> result(std::size_t(large.shapes.n_owned_cells()) *
                               width);
    for (const auto &[family, cell] : here)
      copy(of_families, family, result, cell, width);
    exchange(large.space.communicator(),
             of_families,
             from,
             large_for,
             width,
             result);
    return result;
  }



  void
  CutCells::prolongate(const State &state, State &on_small) const
  {
    CellStateReader      reader(large.space, state);
    const FamilyTransfer transfer(reader.layout);
    CellStateWriter      writer(small.space, on_small);
    std::vector<double>  values, of_large;
    for (const OwnedCell cell : large.owned_cells())
      {
        reader.read(cell.iterator, values);
        of_large.insert(of_large.end(), values.begin(), values.end());
      }
    const unsigned int width       = reader.layout.size();
    const auto         of_families = to_families(of_large, width);
    for (const OwnedCell cell : small.owned_cells())
      {
        const Member &member = members[cell.index];
        const auto    begin =
          of_families.begin() + std::size_t(member.family) * width;
        values.assign(begin, begin + width);
        writer.write(cell.iterator, transfer.to_child(member.child, values));
      }
    on_small.globals = state.globals;
    make_conforming(small.space, on_small);
  }



  void
  CutCells::prolongate(Vector &y, const Vector &x) const
  {
    const unsigned int  n_large = large.shapes.n_owned_cells();
    std::vector<double> of_large(std::size_t(n_per_cell) * n_large);
    x.update_ghost_values();
    for (unsigned int i = 0; i < n_large; ++i)
      large_unknowns.read_free(i, x, &of_large[n_per_cell * i]);
    x.zero_out_ghost_values();
    const auto of_families = to_families(of_large, n_per_cell);

    small_unknowns.reinit_vector(y);
    const unsigned int n_owned     = y.locally_owned_size();
    const auto        &constrained = small_unknowns.is_constrained();
    double             values[n_per_cell];
    for (unsigned int i = 0; i < members.size(); ++i)
      {
        embedding.embed(members[i].child,
                        &of_families[n_per_cell * members[i].family],
                        values);
        for (unsigned int k = 0; k < n_per_cell; ++k)
          {
            const unsigned int place = small_unknowns.places(i)[k];
            if (place < n_owned && !constrained[place])
              y.local_element(place) = values[k];
          }
      }
  }



  void
  CutCells::restrict_to(Vector &y, const Vector &x) const
  {
    std::vector<double> of_families(std::size_t(n_per_cell) * n_families, 0.);
    double              values[n_per_cell];
    x.update_ghost_values();
    for (unsigned int i = 0; i < members.size(); ++i)
      {
        small_unknowns.read(i, x, values);
        for (unsigned int k = 0; k < n_per_cell; ++k)
          values[k] *= small_unknowns.is_constrained(i, k) ?
                         0. :
                         shares.local_element(small_unknowns.places(i)[k]);
        embedding.add_transposed(members[i].child,
                                 values,
                                 &of_families[n_per_cell * members[i].family]);
      }
    x.zero_out_ghost_values();

    const auto of_large = to_large(of_families, n_per_cell);
    large_unknowns.reinit_vector(y);
    for (unsigned int i = 0; i < large.shapes.n_owned_cells(); ++i)
      large_unknowns.add(i, &of_large[n_per_cell * i], y);
    y.compress(dealii::VectorOperation::add);
  }



  std::vector<double>
  CutCells::products(const Vector &x, const Vector &y) const
  {
    std::vector<double> of_families(n_families, 0.);
    x.update_ghost_values();
    y.update_ghost_values();
    for (unsigned int i = 0; i < members.size(); ++i)
      for (unsigned int k = 0; k < n_per_cell; ++k)
        if (!small_unknowns.is_constrained(i, k))
          {
            const unsigned int place = small_unknowns.places(i)[k];
            of_families[members[i].family] += shares.local_element(place) *
                                              x.local_element(place) *
                                              y.local_element(place);
          }
    x.zero_out_ghost_values();
    y.zero_out_ghost_values();
    auto of_large = to_large(of_families, 1);
    for (double &sum : of_large)
      sum = std::abs(sum);
    return of_large;
  }
} // namespace lumbricus
