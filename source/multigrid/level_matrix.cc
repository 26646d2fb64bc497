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

    void
    sort_uniquely(std::vector<Index> &list)
    {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }



    // Found by where the ranks' stretches begin; of stretches that begin at the
    // same place all but the last are empty.
    unsigned int
    owner(const std::vector<Index> &firsts, const Index index)
    {
      return std::upper_bound(firsts.begin(), firsts.end(), index) -
             firsts.begin() - 1;
    }
  } // namespace



  void
  LevelMatrix::reinit(const CellUnknowns &unknowns,
                      const unsigned int  n_cells,
                      const MPI_Comm      communicator)
  {
    comm          = communicator;
    n_owned_cells = n_cells;
    Vector of_unknowns;
    unknowns.reinit_vector(of_unknowns);
    const auto partitioner = of_unknowns.get_partitioner();
    const auto firsts =
      dealii::Utilities::MPI::all_gather(comm,
                                         partitioner->local_range().first);

    // Cells with rows that other ranks own go to these too.
    std::vector<std::vector<Index>>            cells;
    std::map<unsigned int, std::vector<Index>> send;
    receivers.assign(n_cells, {});
    for (unsigned int i = 0; i < n_cells; ++i)
      {
        std::vector<Index>     indices;
        std::set<unsigned int> others;
        for (const unsigned int place : unknowns.free_unknowns(i))
          {
            indices.push_back(partitioner->local_to_global(place));
            if (place >= partitioner->locally_owned_size())
              others.insert(owner(firsts, indices.back()));
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

    // The owned rows, in global numbers; then copies of those that are not
    // owned but unknowns of owned cells.
    const unsigned int n_rows = partitioner->locally_owned_size();
    const Index        first  = partitioner->local_range().first;
    std::vector<std::vector<unsigned int>> cells_of_row(n_rows);
    std::vector<Index>                     wanted;
    for (unsigned int i = 0; i < cells.size(); ++i)
      for (const Index index : cells[i])
        if (partitioner->in_local_range(index))
          cells_of_row[index - first].push_back(i);
        else if (i < n_cells)
          wanted.push_back(index);
    sort_uniquely(wanted);
    std::vector<std::vector<Index>> rows(n_rows);
    std::vector<Index>              needed;
    for (unsigned int r = 0; r < n_rows; ++r)
      {
        for (const unsigned int i : cells_of_row[r])
          rows[r].insert(rows[r].end(), cells[i].begin(), cells[i].end());
        sort_uniquely(rows[r]);
      }
    exchange_rows(wanted, firsts, first, rows);
    for (const auto &row : rows)
      for (const Index index : row)
        if (!partitioner->in_local_range(index))
          needed.push_back(index);
    sort_uniquely(needed);
    dealii::IndexSet ghosts(partitioner->size());
    ghosts.add_indices(needed.begin(), needed.end());
    columns = std::make_shared<dealii::Utilities::MPI::Partitioner>(
      partitioner->locally_owned_range(), ghosts, comm);

    copy_at.assign(columns->n_ghost_indices(),
                   dealii::numbers::invalid_unsigned_int);
    for (unsigned int k = 0; k < wanted.size(); ++k)
      copy_at[columns->global_to_local(wanted[k]) - n_rows] = n_rows + k;

    of_cell.assign(cells.size(), {});
    sorted.assign(cells.size(), {});
    for (unsigned int i = 0; i < cells.size(); ++i)
      {
        for (const Index index : cells[i])
          of_cell[i].push_back(columns->global_to_local(index));
        sorted[i].resize(cells[i].size());
        std::iota(sorted[i].begin(), sorted[i].end(), 0u);
        std::sort(sorted[i].begin(),
                  sorted[i].end(),
                  [&](const unsigned int a, const unsigned int b) {
                    return cells[i][a] < cells[i][b];
                  });
      }

    // Columns are kept in the order of the global numbers.
    row_begin.assign(1, 0);
    column.clear();
    for (const auto &row : rows)
      {
        for (const Index index : row)
          column.push_back(columns->global_to_local(index));
        row_begin.push_back(column.size());
      }
    column.shrink_to_fit();
    values.resize(column.size());
  }



  void
  LevelMatrix::exchange_rows(const std::vector<Index>        &wanted,
                             const std::vector<Index>        &firsts,
                             const Index                      first,
                             std::vector<std::vector<Index>> &rows)
  {
    std::map<unsigned int, std::vector<Index>> requests, replies;
    first_copy_from.clear();
    rows_for.clear();
    for (unsigned int k = 0; k < wanted.size(); ++k)
      {
        const unsigned int rank = owner(firsts, wanted[k]);
        first_copy_from.emplace(rank, rows.size() + k);
        requests[rank].push_back(wanted[k]);
      }
    for (const auto &[rank, indices] :
         dealii::Utilities::MPI::some_to_some(comm, requests))
      for (const Index index : indices)
        {
          const auto &row = rows[index - first];
          rows_for[rank].push_back(index - first);
          replies[rank].push_back(row.size());
          replies[rank].insert(replies[rank].end(), row.begin(), row.end());
        }
    rows.resize(rows.size() + wanted.size());
    for (const auto &[rank, message] :
         dealii::Utilities::MPI::some_to_some(comm, replies))
      {
        unsigned int copy = first_copy_from.at(rank);
        for (auto at = message.begin(); at != message.end(); ++copy)
          {
            const auto size = *at++;
            rows[copy].assign(at, at + size);
            at += size;
          }
      }
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

    std::map<unsigned int, std::vector<float>> send;
    for (const auto &[rank, rows] : rows_for)
      for (const unsigned int r : rows)
        send[rank].insert(send[rank].end(),
                          values.begin() + row_begin[r],
                          values.begin() + row_begin[r + 1]);
    for (const auto &[rank, copies] :
         dealii::Utilities::MPI::some_to_some(comm, send))
      std::copy(copies.begin(),
                copies.end(),
                values.begin() + row_begin[first_copy_from.at(rank)]);
  }



  void
  LevelMatrix::add_rows(const unsigned int cell, const double *matrix)
  {
    // The unknowns of the row and of the cell are gone through in order.
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
  LevelMatrix::residual(const Vector &x, const double *b, double *r) const
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
