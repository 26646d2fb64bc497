// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/linear/mumps.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/exceptions.h>
#include <deal.II/base/types.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <new>
#include <string>

#include "mumps_errors.h"
#include "mumps_instance.h"

namespace lumbricus
{
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
    run(Instance::initialise);

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
    instance->data.job = Instance::terminate;
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
    check_mumps({instance->info(1), instance->info(2), instance->data.info[0]},
                what,
                sizeof(Number),
                comm == told,
                told);
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
        run(Instance::factorise);
        if (!is_out_of_estimate(instance->info(1)) ||
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
        run(Instance::back_substitute);
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
    run(Instance::back_substitute);
    if (comm == told)
      check("back substitution");
    else
      {
        // To ask the others every time would take longer than to end them.
        const int code = instance->info(1);
        if (is_out_of_memory(code))
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
