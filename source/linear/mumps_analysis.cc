// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/linear/mumps.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "mumps_instance.h"
#include "mumps_ordering.h"

namespace lumbricus
{
  template <typename Number>
  void
  Mumps<Number>::add_pattern(const unsigned int *places, const unsigned int n)
  {
    for (unsigned int r = 0; r < n; ++r)
      for (unsigned int s = 0; s < (symmetric ? r + 1 : n); ++s)
        {
          // MUMPS counts from one.
          const int row    = numbering.number(places[r]) + 1;
          const int column = numbering.number(places[s]) + 1;
          rows.push_back(symmetric ? std::max(row, column) : row);
          columns.push_back(symmetric ? std::min(row, column) : column);
        }
  }



  template <typename Number>
  void
  Mumps<Number>::analyse(const CellUnknowns              &unknowns,
                         const unsigned int               n_cells,
                         const unsigned int               n_left_out,
                         const MoreEntries               &more,
                         const std::vector<unsigned int> &not_eliminated)
  {
    const bool is_first = dealii::Utilities::MPI::this_mpi_process(comm) == 0;
    for (unsigned int i = 0; i < n_cells; ++i)
      {
        const auto places = unknowns.free_unknowns(i);
        add_pattern(places.data() + n_left_out, places.size() - n_left_out);
      }
    std::vector<int> order;
    if (more.n_unknowns > 0 || !not_eliminated.empty())
      {
        order                  = order_with(more, not_eliminated);
        instance->control(7)   = 1; // the ordering is given
        instance->data.perm_in = order.data();
      }
    left_unknowns.clear();
    for (const unsigned int number : not_eliminated)
      left_unknowns.push_back(number + 1);
    for (const MatrixEntries *entries : {&more.own, &more.common})
      if (entries == &more.own || is_first)
        for (unsigned int k = 0; k < entries->rows.size(); ++k)
          {
            rows.push_back(entries->rows[k] + 1);
            columns.push_back(entries->columns[k] + 1);
          }

    // MUMPS counts from one.
    const unsigned int n_given = numbering.n_owned();
    unsigned int       first   = 0;
    MPI_Exscan(&n_given, &first, 1, MPI_UNSIGNED, MPI_SUM, comm);
    given.resize(n_given + (is_first ? more.n_unknowns : 0));
    std::iota(given.begin(), given.begin() + n_given, first + 1);
    std::iota(given.begin() + n_given, given.end(), numbering.size() + 1);
    plan(numbering.size() + more.n_unknowns);
    check("analysis of the matrix");
  }



  template <typename Number>
  void
  Mumps<Number>::plan(const unsigned int n_unknowns)
  {
    entries.resize(rows.size());
    auto &data   = instance->data;
    data.n       = n_unknowns;
    data.nnz_loc = rows.size();
    data.irn_loc = rows.data();
    data.jcn_loc = columns.data();
    data.a_loc   = entries.data();
    const std::size_t n_left = left_unknowns.size();
    left.resize(n_left * n_left);
    // What is left is given back by rows.
    instance->control(19) = n_left > 0 ? 1 : 0;
    data.size_schur       = n_left;
    data.listvar_schur    = left_unknowns.data();
    data.schur            = left.data();
    data.lredrhs          = n_left;
    Assert(n_left == 0 || is_alone, dealii::ExcInternalError());
    run(Instance::analysis);
  }



  template <typename Number>
  std::vector<int>
  Mumps<Number>::planned_positions(const unsigned int n_unknowns)
  {
    // The first rank knows them. Not all ranks that are told are here: what goes
    // wrong now will do so again where they are.
    plan(n_unknowns);
    std::vector<int> positions(n_unknowns);
    std::iota(positions.begin(), positions.end(), 1);
    if (dealii::Utilities::MPI::this_mpi_process(comm) == 0 &&
        instance->info(1) >= 0)
      std::copy_n(instance->data.sym_perm, n_unknowns, positions.begin());
    MPI_Bcast(positions.data(), n_unknowns, MPI_INT, 0, comm);
    return positions;
  }



  template <typename Number>
  std::vector<int>
  Mumps<Number>::positions_with_left(const unsigned int n_left)
  {
    const unsigned int n            = numbering.size();
    const unsigned int n_eliminated = n - n_left;
    std::vector<int>   every(n);
    std::iota(every.begin(), every.end(), 1);
    if (n_eliminated == 1)
      return every;

    // With what is left MUMPS orders by minimum degrees: with rounding errors that
    // cost iterations, and far more operations where much is left. So it dissects
    // those that are eliminated, and does not know the others.
    std::vector<int> all_rows, all_columns;
    all_rows.swap(rows);
    all_columns.swap(columns);
    for (std::size_t k = 0; k < all_rows.size(); ++k)
      if (std::max(all_rows[k], all_columns[k]) <= int(n_eliminated))
        {
          rows.push_back(all_rows[k]);
          columns.push_back(all_columns[k]);
        }
    left_unknowns.clear();
    std::vector<int> positions = planned_positions(n_eliminated);
    positions.insert(positions.end(), every.begin() + n_eliminated, every.end());
    rows.swap(all_rows);
    columns.swap(all_columns);
    return positions;
  }



  template <typename Number>
  std::vector<int>
  Mumps<Number>::order_with(const MoreEntries               &more,
                            const std::vector<unsigned int> &not_eliminated)
  {
    const unsigned int n = numbering.size();
    const unsigned int n_left_of_cells =
      std::count_if(not_eliminated.begin(),
                    not_eliminated.end(),
                    [n](const unsigned int number) { return number < n; });
    std::vector<int> positions = n_left_of_cells > 0 ?
                                   positions_with_left(n_left_of_cells) :
                                   planned_positions(n);
    return ordering_with(std::move(positions), more, not_eliminated, comm);
  }



  template void
  Mumps<double>::analyse(const CellUnknowns &,
                         const unsigned int,
                         const unsigned int,
                         const MoreEntries &,
                         const std::vector<unsigned int> &);

  template void
  Mumps<float>::analyse(const CellUnknowns &,
                        const unsigned int,
                        const unsigned int,
                        const MoreEntries &,
                        const std::vector<unsigned int> &);
} // namespace lumbricus
