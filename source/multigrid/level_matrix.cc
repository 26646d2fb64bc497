// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/multigrid/level_matrix.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace lumbricus
{
  namespace
  {
    using Index = dealii::types::global_dof_index;
  }



  void
  LevelMatrix::reinit(const CellUnknowns &unknowns,
                      const unsigned int  n_cells,
                      const MPI_Comm      communicator)
  {
    comm          = communicator;
    n_owned_cells = n_cells;
    const auto partitioner = unknowns.make_vector().get_partitioner();
    const auto firsts =
      dealii::Utilities::MPI::all_gather(comm,
                                         partitioner->local_range().first);
    const auto owner = [&](const Index index) {
      return static_cast<unsigned int>(
        std::upper_bound(firsts.begin(), firsts.end(), index) -
        firsts.begin() - 1);
    };

    // Cells with rows that other ranks own go to these too.
    std::vector<std::vector<Index>>            cells;
    std::map<unsigned int, std::vector<Index>> send;
    std::vector<unsigned int>                  own;
    receivers.assign(n_cells, {});
    for (unsigned int i = 0; i < n_cells; ++i)
      {
        std::vector<Index>     indices;
        std::set<unsigned int> others;
        for (const unsigned int place : unknowns.free_unknowns(i, own))
          {
            indices.push_back(partitioner->local_to_global(place));
            if (place >= partitioner->locally_owned_size())
              others.insert(owner(indices.back()));
          }
        receivers[i].assign(others.begin(), others.end());
        for (const unsigned int rank : others)
          {
            send[rank].push_back(indices.size());
            send[rank].insert(send[rank].end(), indices.begin(), indices.end());
          }
        cells.push_back(std::move(indices));
      }
    received.clear();
    for (const auto &[rank, message] :
         dealii::Utilities::MPI::some_to_some(comm, send))
      {
        unsigned int n = 0;
        for (auto at = message.begin(); at != message.end(); ++n)
          {
            const auto size = *at++;
            cells.emplace_back(at, at + size);
            at += size;
          }
        received.emplace_back(rank, n);
      }

    std::vector<Index> needed;
    for (const auto &cell : cells)
      for (const Index index : cell)
        if (!partitioner->in_local_range(index))
          needed.push_back(index);
    std::sort(needed.begin(), needed.end());
    needed.erase(std::unique(needed.begin(), needed.end()), needed.end());
    dealii::IndexSet ghosts(partitioner->size());
    ghosts.add_indices(needed.begin(), needed.end());
    columns = std::make_shared<dealii::Utilities::MPI::Partitioner>(
      partitioner->locally_owned_range(), ghosts, comm);

    const unsigned int n_rows = columns->locally_owned_size();
    of_cell.assign(cells.size(), {});
    sorted.assign(cells.size(), {});
    owned_of_cell.assign(n_cells, {});
    std::vector<std::vector<unsigned int>> cells_of_row(n_rows);
    for (unsigned int i = 0; i < cells.size(); ++i)
      {
        for (const Index index : cells[i])
          of_cell[i].push_back(columns->global_to_local(index));
        sorted[i].resize(cells[i].size());
        std::iota(sorted[i].begin(), sorted[i].end(), 0u);
        std::sort(sorted[i].begin(),
                  sorted[i].end(),
                  [&](const unsigned int a, const unsigned int b) {
                    return of_cell[i][a] < of_cell[i][b];
                  });
        for (const unsigned int place : of_cell[i])
          if (place < n_rows)
            {
              cells_of_row[place].push_back(i);
              if (i < n_cells)
                owned_of_cell[i].push_back(place);
            }
      }

    row_begin.assign(1, 0);
    column.clear();
    std::vector<unsigned int> merged;
    for (unsigned int r = 0; r < n_rows; ++r)
      {
        merged.clear();
        for (const unsigned int i : cells_of_row[r])
          merged.insert(merged.end(), of_cell[i].begin(), of_cell[i].end());
        std::sort(merged.begin(), merged.end());
        merged.erase(std::unique(merged.begin(), merged.end()), merged.end());
        column.insert(column.end(), merged.begin(), merged.end());
        row_begin.push_back(column.size());
      }
    column.shrink_to_fit();
    values.resize(column.size());
  }



  void
  LevelMatrix::begin()
  {
    std::fill(values.begin(), values.end(), 0.f);
    outgoing.clear();
  }



  void
  LevelMatrix::add(const unsigned int i, const std::vector<double> &matrix)
  {
    add_rows(i, matrix.data());
    for (const unsigned int rank : receivers[i])
      outgoing[rank].insert(outgoing[rank].end(), matrix.begin(), matrix.end());
  }



  void
  LevelMatrix::finish()
  {
    const auto incoming = dealii::Utilities::MPI::some_to_some(comm, outgoing);
    outgoing.clear();
    unsigned int cell = n_owned_cells;
    for (const auto &[rank, n] : received)
      {
        const double *matrix = incoming.at(rank).data();
        for (unsigned int k = 0; k < n; ++k, ++cell)
          {
            add_rows(cell, matrix);
            matrix += of_cell[cell].size() * of_cell[cell].size();
          }
      }
  }



  void
  LevelMatrix::add_rows(const unsigned int cell, const double *matrix)
  {
    // Both the row and the cell's unknowns are gone through in order.
    const auto        &places = of_cell[cell];
    const auto        &order  = sorted[cell];
    const unsigned int n      = places.size();
    for (unsigned int a = 0; a < n; ++a)
      {
        if (places[a] >= n_owned())
          continue;
        const double *const from = matrix + std::size_t(a) * n;
        std::size_t         at   = row_begin[places[a]];
        for (const unsigned int b : order)
          {
            while (column[at] != places[b])
              ++at;
            values[at] += static_cast<float>(from[b]);
          }
      }
  }



  void
  LevelMatrix::residual(const CellVector &x, const double *b, double *r) const
  {
    const double *const entries = x.begin();
    for (unsigned int i = 0; i < n_owned(); ++i)
      {
        double sum = b[i];
#pragma omp simd reduction(- : sum)
        for (std::size_t k = row_begin[i]; k < row_begin[i + 1]; ++k)
          sum -= values[k] * entries[column[k]];
        r[i] = sum;
      }
  }
} // namespace lumbricus
