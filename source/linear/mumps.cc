// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/out_of_memory.h>
#include <lumbricus/linear/mumps.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/types.h>

#include <dmumps_c.h>
#include <smumps_c.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <new>
#include <numeric>
#include <string>
#include <utility>

namespace lumbricus
{
  namespace
  {
    // MUMPS' names for what run() does.
    constexpr int initialise = -1, terminate = -2, analysis = 1, factorise = 2,
                  back_substitute = 3;

    const std::string advice =
      "Its manual says what that is. Try another 'Linear solver/Method'.";

    // Delayed pivots may need more room than the analysis foresaw.
    constexpr int out_of_estimate[] = {-8, -9, -20};

    // Real and integer workspace, and what it allocates besides; more room than
    // was foreseen, where that is not to be had either; its own limit.
    constexpr int out_of_memory[] = {
      -5, -7, -8, -9, -11, -13, -14, -15, -19, -20};

    template <std::size_t n>
    bool
    is_one_of(const int code, const int (&codes)[n])
    {
      return std::find(codes, codes + n, code) != codes + n;
    }

    // What of MUMPS depends on the precision.
    template <typename Number>
    struct Precision;

    template <>
    struct Precision<double>
    {
      using Data                 = DMUMPS_STRUC_C;
      static constexpr auto call = dmumps_c;

      static MPI_Datatype
      mpi()
      {
        return MPI_DOUBLE;
      }
    };

    template <>
    struct Precision<float>
    {
      using Data                 = SMUMPS_STRUC_C;
      static constexpr auto call = smumps_c;

      static MPI_Datatype
      mpi()
      {
        return MPI_FLOAT;
      }
    };
  } // namespace



  /** What MUMPS is called with: its structure, by the numbers of its manual,
   * which start at one. */
  template <typename Number>
  struct Mumps<Number>::Instance
  {
    /** Of dmumps_c.h or smumps_c.h. */
    typename Precision<Number>::Data data;

    /** ICNTL(i), an option. */
    MUMPS_INT &
    control(const int i)
    {
      return data.icntl[i - 1];
    }

    /** INFOG(i), the same on all ranks; what is negative is an error. */
    MUMPS_INT
    info(const int i) const
    {
      return data.infog[i - 1];
    }

    /** RINFOG(i), the same on all ranks. */
    double
    real_info(const int i) const
    {
      return data.rinfog[i - 1];
    }
  };



  template <typename Number>
  Mumps<Number>::Mumps(const MPI_Comm       comm,
                       const Options       &options,
                       const FreeNumbering &numbering,
                       const MPI_Comm       told)
    : comm(comm)
    , told(told)
    , is_alone(dealii::Utilities::MPI::n_mpi_processes(comm) == 1)
    , symmetric(options.symmetric)
    , compressed(options.compression > 0.)
    , numbering(numbering)
    , instance(std::make_unique<Instance>())
  {
    instance->data              = {};
    instance->data.par          = 1; // rank 0 works too
    instance->data.sym          = symmetric ? (options.pivoting ? 2 : 1) : 0;
    instance->data.comm_fortran = static_cast<MUMPS_INT>(MPI_Comm_c2f(comm));
    run(initialise);

    instance->control(1)  = -1; // no messages: factor() looks at the result
    instance->control(2)  = -1;
    instance->control(3)  = -1;
    instance->control(4)  = 0;
    instance->control(7)  = 5;  // dissection: Metis where MUMPS has it, or PORD
    instance->control(14) = 40; // percent of memory beyond the estimate
    instance->control(18) = 3;  // the matrix is distributed
    if (!options.pivoting)
      {
        instance->control(13) =
          1; // no ScaLAPACK: it insists on positive pivots
        instance->data.cntl[0] = 0.;
      }
    if (options.compression > 0.)
      {
        instance->control(35)  = 2; // block low rank: factors and solutions
        instance->control(36)  = 1; // compress before the rest is computed
        instance->data.cntl[6] = options.compression;
      }
  }



  template <typename Number>
  Mumps<Number>::~Mumps()
  {
    // To end it takes all ranks, and where memory ends on one, or something
    // else is wrong there, the others are not here.
    if (std::uncaught_exceptions() > 0 && !is_alone)
      return;
    instance->data.job = terminate;
    Precision<Number>::call(&instance->data);
  }



  template <typename Number>
  void
  Mumps<Number>::run(const int job)
  {
    instance->data.job = job;
    Precision<Number>::call(&instance->data);
  }



  template <typename Number>
  void
  Mumps<Number>::check(const std::string &what) const
  {
    // The same on all ranks of comm. Other ranks that are told have a MUMPS of
    // their own, which may be content.
    const int code = comm == told ?
                       instance->info(1) :
                       dealii::Utilities::MPI::min(instance->info(1), told);
    if (code >= 0)
      return;
    AssertThrow(code != -10,
                ExcNotConverged("The tangent matrix is singular"));
    const bool is_here = instance->info(1) == code;
    const int  detail  = dealii::Utilities::MPI::max(
      is_here ? std::abs(instance->info(2)) : 0, told);
    if (is_one_of(code, out_of_memory))
      {
        // Entries, in millions where there are many; only the rank concerned
        // has the code itself.
        const bool in_millions = dealii::Utilities::MPI::logical_or(
          is_here && instance->info(2) < 0, told);
        const double       entries_lacking = in_millions ? 1e6 * detail : detail;
        const bool         integers        = code == -7 || code == -8;
        const unsigned int n_ranks =
          dealii::Utilities::MPI::n_mpi_processes(told);
        const unsigned int rank = dealii::Utilities::MPI::min(
          instance->data.info[0] == code ?
            dealii::Utilities::MPI::this_mpi_process(told) :
            n_ranks,
          told);
        AssertThrow(false,
                    ExcSolveFailed(
                      out_of_memory_message(
                        entries_lacking *
                          (integers ? sizeof(MUMPS_INT) : sizeof(Number)),
                        rank < n_ranks ? rank : 0,
                        told) +
                      " (In the " + what + " by MUMPS, code " +
                      std::to_string(code) + ".)"));
      }
    AssertThrow(false,
                ExcSolveFailed("The " + what + " by MUMPS failed with code " +
                               std::to_string(code) + ", " +
                               std::to_string(detail) + ". " + advice));
  }



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
    run(analysis);
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

    // Where the others come among them.
    std::vector<int> last(more.n_unknowns, 0);
    for (unsigned int k = 0; k < more.own.rows.size(); ++k)
      for (const auto &[global, other] :
           {std::make_pair(more.own.rows[k], more.own.columns[k]),
            std::make_pair(more.own.columns[k], more.own.rows[k])})
        if (global >= n && other < n)
          last[global - n] = std::max(last[global - n], positions[other]);
    dealii::Utilities::MPI::max(last, comm, last);
    for (const unsigned int number : not_eliminated)
      if (number >= n)
        last[number - n] = n;

    // Each goes behind the last one that it hangs together with.
    std::vector<int> shift(n + 2, 0);
    for (const int position : last)
      ++shift[position + 1];
    std::partial_sum(shift.begin(), shift.end(), shift.begin());
    for (int &position : positions)
      position += shift[position];
    for (const int position : last)
      positions.push_back(position + shift[position]++ + 1);
    return positions;
  }



  template <typename Number>
  double
  Mumps<Number>::planned_flops() const
  {
    return instance->real_info(1);
  }



  template <typename Number>
  double
  Mumps<Number>::planned_megabytes() const
  {
    return instance->info(compressed ? 36 : 16);
  }



  template <typename Number>
  void
  Mumps<Number>::begin()
  {
    next = 0;
  }



  template <typename Number>
  void
  Mumps<Number>::add(const unsigned int n, const double *matrix)
  {
    for (unsigned int r = 0; r < n; ++r)
      for (unsigned int s = 0; s < (symmetric ? r + 1 : n); ++s)
        {
          AssertIndexRange(next, entries.size());
          entries[next++] = static_cast<Number>(matrix[r * n + s]);
        }
  }



  template <typename Number>
  void
  Mumps<Number>::add(const MoreEntries &more)
  {
    for (const double value : more.own.values)
      entries[next++] = static_cast<Number>(value);
    if (dealii::Utilities::MPI::this_mpi_process(comm) == 0)
      for (const double value : more.common.values)
        entries[next++] = static_cast<Number>(value);
    AssertDimension(next, entries.size());
  }



  template <typename Number>
  void
  Mumps<Number>::factor()
  {
    constexpr int most_percent = 1000;
    while (true)
      {
        run(factorise);
        if (!is_one_of(instance->info(1), out_of_estimate) ||
            instance->control(14) >= most_percent)
          break;
        instance->control(14) *= 2;
      }
    check("factorisation");
    is_found_known = false;
  }



  template <typename Number>
  void
  Mumps<Number>::solve(std::vector<Number> &values, std::vector<Number> &more)
  {
    given_values = values;
    given_values.insert(given_values.end(), more.begin(), more.end());
    AssertDimension(given_values.size(), given.size());
    if (is_alone)
      solve_alone(given_values);
    else
      {
        // MUMPS does not take null pointers.
        auto &data = instance->data;
        found.resize(std::max(1, data.info[22]));
        found_values.resize(found.size());
        given.reserve(1);
        given_values.reserve(1);
        instance->control(20) = 10; // the right-hand side is distributed
        instance->control(21) = 1;  // and so is the solution
        data.nloc_rhs         = given.size();
        data.lrhs_loc         = std::max<std::size_t>(1, given.size());
        data.irhs_loc         = given.data();
        data.rhs_loc          = given_values.data();
        data.lsol_loc         = found.size();
        data.isol_loc         = found.data();
        data.sol_loc          = found_values.data();
        run(back_substitute);
        check("back substitution");
        found_values.resize(data.info[22]);
        if (!is_found_known)
          {
            using Indices = std::vector<dealii::types::global_dof_index>;
            Indices at(found.begin(), found.begin() + found_values.size());
            Indices wanted(given.begin(), given.end());
            for (Indices *indices : {&at, &wanted})
              for (auto &index : *indices)
                --index;
            to_given.reinit(at, wanted, comm);
            is_found_known = true;
          }
        to_given.template export_to_ghosted_array<Number>(
          dealii::ArrayView<const Number>(found_values.data(),
                                          found_values.size()),
          dealii::ArrayView<Number>(given_values.data(), given_values.size()));
      }
    std::copy_n(given_values.begin(), values.size(), values.begin());
    std::copy(given_values.begin() + values.size(),
              given_values.end(),
              more.begin());
  }



  template <typename Number>
  void
  Mumps<Number>::solve_alone(std::vector<Number> &values)
  {
    instance->data.rhs = values.data();
    run(back_substitute);
    if (comm == told)
      check("back substitution");
    else
      {
        // To ask the others every time would take longer than to end them.
        const int code = instance->info(1);
        if (is_one_of(code, out_of_memory))
          throw std::bad_alloc();
        AssertThrow(code >= 0,
                    dealii::ExcMessage("The back substitution by MUMPS on a rank "
                                       "failed with code " +
                                       std::to_string(code) + "."));
      }
  }



  template <typename Number>
  void
  Mumps<Number>::reduce(std::vector<Number> &all, std::vector<Number> &of_left)
  {
    if (left_unknowns.empty())
      return;
    reduced.resize(left_unknowns.size());
    for (const int unknown : left_unknowns)
      all[unknown - 1] = 0.;
    instance->data.redrhs = reduced.data();
    instance->control(26) = 1;
    solve_alone(all);
    for (unsigned int k = 0; k < reduced.size(); ++k)
      of_left[k] += reduced[k];
  }



  template <typename Number>
  void
  Mumps<Number>::expand(const std::vector<Number> &of_left,
                        std::vector<Number>       &all)
  {
    if (!left_unknowns.empty())
      {
        reduced               = of_left;
        instance->data.redrhs = reduced.data();
        instance->control(26) = 2;
      }
    solve_alone(all);
  }



  template <typename Number>
  double
  Mumps<Number>::factor_flops() const
  {
    return instance->real_info(3);
  }



  template <typename Number>
  double
  Mumps<Number>::factor_entries() const
  {
    // Beyond what an int holds MUMPS counts in millions, with a minus sign.
    const double n = instance->info(29);
    return n >= 0. ? n : -1e6 * n;
  }



  template <typename Number>
  double
  Mumps<Number>::cost(const double flops, const double n_entries)
  {
    // A factorisation is arithmetic and some overhead, a back substitution
    // reads the factors twice: fitted to what both took on meshes of 17,000 to
    // 124,000 unknowns.
    return 17. + flops / (200. * n_entries);
  }



  template class Mumps<double>;
  template class Mumps<float>;
} // namespace lumbricus
