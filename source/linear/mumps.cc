// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/out_of_memory.h>
#include <lumbricus/linear/mumps.h>

#include <dmumps_c.h>
#include <smumps_c.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <cstddef>
#include <exception>
#include <string>

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
                       const FreeNumbering &numbering)
    : comm(comm)
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
    instance->control(7)  = 5;  // ordering by Metis
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
    if (std::uncaught_exceptions() > 0 &&
        dealii::Utilities::MPI::n_mpi_processes(comm) > 1)
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
    const int code = instance->info(1);
    if (code >= 0)
      return;
    AssertThrow(code != -10,
                ExcNotConverged("The tangent matrix is singular"));
    if (is_one_of(code, out_of_memory))
      {
        // Entries, in millions where there are many; only the rank concerned
        // has the code itself.
        const double       n = instance->info(2);
        const double       entries_lacking = n >= 0. ? n : -1e6 * n;
        const bool         integers        = code == -7 || code == -8;
        const unsigned int n_ranks =
          dealii::Utilities::MPI::n_mpi_processes(comm);
        const unsigned int rank = dealii::Utilities::MPI::min(
          instance->data.info[0] == code ?
            dealii::Utilities::MPI::this_mpi_process(comm) :
            n_ranks,
          comm);
        AssertThrow(false,
                    ExcSolveFailed(
                      out_of_memory_message(
                        entries_lacking *
                          (integers ? sizeof(MUMPS_INT) : sizeof(Number)),
                        rank < n_ranks ? rank : 0,
                        comm) +
                      " (In the " + what + " by MUMPS, code " +
                      std::to_string(code) + ".)"));
      }
    AssertThrow(false,
                ExcSolveFailed("The " + what + " by MUMPS failed with code " +
                               std::to_string(code) + ", " +
                               std::to_string(instance->info(2)) + ". " +
                               advice));
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
  Mumps<Number>::analyse(const CellUnknowns &unknowns,
                         const unsigned int  n_cells,
                         const unsigned int  n_left_out,
                         const MoreEntries  &more)
  {
    for (unsigned int i = 0; i < n_cells; ++i)
      {
        const auto places = unknowns.free_unknowns(i);
        add_pattern(places.data() + n_left_out, places.size() - n_left_out);
      }
    std::vector<int> order;
    if (more.n_unknowns > 0)
      {
        plan(0);
        order = order_with(more);
        for (unsigned int k = 0; k < more.rows.size(); ++k)
          {
            rows.push_back(more.rows[k] + 1);
            columns.push_back(more.columns[k] + 1);
          }
        instance->control(7)   = 1; // the ordering is given
        instance->data.perm_in = order.data();
      }

    counts =
      dealii::Utilities::MPI::all_gather(comm,
                                         static_cast<int>(numbering.n_owned()));
    offsets = counts;
    for (unsigned int r = 0, sum = 0; r < counts.size(); ++r)
      {
        offsets[r] = sum;
        sum += counts[r];
      }
    if (dealii::Utilities::MPI::this_mpi_process(comm) == 0)
      centralised.resize(numbering.size() + more.n_unknowns);
    plan(more.n_unknowns);
  }



  template <typename Number>
  void
  Mumps<Number>::plan(const unsigned int n_more)
  {
    entries.resize(rows.size());
    auto &data   = instance->data;
    data.n       = numbering.size() + n_more;
    data.nnz_loc = rows.size();
    data.irn_loc = rows.data();
    data.jcn_loc = columns.data();
    data.a_loc   = entries.data();
    run(analysis);
    check("analysis of the matrix");
  }



  template <typename Number>
  std::vector<int>
  Mumps<Number>::order_with(const MoreEntries &more) const
  {
    // Where they come among the others, which the first rank knows.
    const unsigned int n = numbering.size();
    std::vector<int>   positions(n);
    if (dealii::Utilities::MPI::this_mpi_process(comm) == 0)
      std::copy(instance->data.sym_perm,
                instance->data.sym_perm + n,
                positions.begin());
    MPI_Bcast(positions.data(), n, MPI_INT, 0, comm);
    std::vector<int> last(more.n_unknowns, 0);
    for (unsigned int k = 0; k < more.rows.size(); ++k)
      for (const auto &[global, other] :
           {std::make_pair(more.rows[k], more.columns[k]),
            std::make_pair(more.columns[k], more.rows[k])})
        if (global >= n && other < n)
          last[global - n] = std::max(last[global - n], positions[other]);
    dealii::Utilities::MPI::max(last, comm, last);

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
    AssertDimension(next + more.values.size(), entries.size());
    for (const double value : more.values)
      entries[next++] = static_cast<Number>(value);
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
  }



  template <typename Number>
  void
  Mumps<Number>::solve(std::vector<Number> &values, std::vector<Number> &more)
  {
    // The right-hand side and the solution are whole on rank 0.
    const MPI_Datatype type = Precision<Number>::mpi();
    const int          n    = values.size();
    MPI_Gatherv(values.data(),
                n,
                type,
                centralised.data(),
                counts.data(),
                offsets.data(),
                type,
                0,
                comm);
    const auto after_all = centralised.end() - more.size();
    std::copy(more.begin(), more.end(), after_all);
    instance->data.rhs = centralised.data();
    run(back_substitute);
    check("back substitution");
    std::copy(after_all, centralised.end(), more.begin());
    MPI_Scatterv(centralised.data(),
                 counts.data(),
                 offsets.data(),
                 type,
                 values.data(),
                 n,
                 type,
                 0,
                 comm);
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
  Mumps<Number>::factor_cost() const
  {
    // A factorisation is arithmetic and some overhead, a back substitution
    // reads the factors twice: fitted to what both took on meshes of 17,000 to
    // 124,000 unknowns.
    return 17. + factor_flops() / (200. * factor_entries());
  }



  template class Mumps<double>;
  template class Mumps<float>;
} // namespace lumbricus
