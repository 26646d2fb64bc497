// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/solvers/mumps.h>

#include <Epetra_CrsMatrix.h>
#include <dmumps_c.h>

#include <string>

namespace lumbricus
{
  namespace
  {
    // MUMPS' names for what run() does.
    constexpr int initialise = -1, terminate = -2, analyse = 1, factorise = 2,
                  back_substitute = 3;



    // Call function(global_row, global_column, value) for the local entries
    // that are handed over, always in the same order.
    template <typename Function>
    void
    for_each_entry(const Matrix   &A,
                   const bool      symmetric,
                   const Function &function)
    {
      const Epetra_CrsMatrix &matrix = A.trilinos_matrix();
      for (int local_row = 0; local_row < matrix.NumMyRows(); ++local_row)
        {
          const int row = matrix.GRID(local_row);
          int       n_entries;
          double   *entries;
          int      *local_columns;
          matrix.ExtractMyRowView(local_row, n_entries, entries, local_columns);
          for (int e = 0; e < n_entries; ++e)
            {
              const int column = matrix.GCID(local_columns[e]);
              if (!symmetric || column <= row)
                function(row, column, entries[e]);
            }
        }
    }
  } // namespace



  struct Mumps::Instance
  {
    DMUMPS_STRUC_C data;

    // ICNTL and INFOG by the numbers of MUMPS' manual, which start at one.
    MUMPS_INT &
    control(const int i)
    {
      return data.icntl[i - 1];
    }

    MUMPS_INT
    info(const int i) const
    {
      return data.infog[i - 1];
    }
  };



  Mumps::Mumps(const MPI_Comm comm, const bool symmetric)
    : comm(comm)
    , symmetric(symmetric)
    , instance(std::make_unique<Instance>())
  {
    instance->data              = {};
    instance->data.par          = 1; // rank 0 works too
    instance->data.sym          = symmetric ? 2 : 0;
    instance->data.comm_fortran = static_cast<MUMPS_INT>(MPI_Comm_c2f(comm));
    run(initialise);

    instance->control(1)  = -1; // no messages: run() looks at the result
    instance->control(2)  = -1;
    instance->control(3)  = -1;
    instance->control(4)  = 0;
    instance->control(7)  = 5;  // ordering by Metis
    instance->control(14) = 40; // percent of memory beyond the estimate
    instance->control(18) = 3;  // the matrix is distributed
  }



  Mumps::~Mumps()
  {
    instance->data.job = terminate;
    dmumps_c(&instance->data);
  }



  void
  Mumps::run(const int job)
  {
    instance->data.job = job;
    dmumps_c(&instance->data);
  }



  void
  Mumps::factor(const Matrix &A)
  {
    if (!analysed)
      {
        read_pattern(A);
        read_values(A);
        run(analyse);
        AssertThrow(instance->info(1) >= 0,
                    ExcSolveFailed("The analysis of the matrix by MUMPS "
                                   "failed with code " +
                                   std::to_string(instance->info(1)) + ", " +
                                   std::to_string(instance->info(2)) + "."));
        analysed = true;
      }
    else
      read_values(A);

    // Delayed pivots may need more room than the analysis foresaw.
    constexpr int out_of_estimate[] = {-8, -9, -20};
    constexpr int most_percent      = 1000;
    while (true)
      {
        run(factorise);
        const int code = instance->info(1);
        if (code >= 0)
          break;

        const bool estimate_short =
          std::find(std::begin(out_of_estimate),
                    std::end(out_of_estimate),
                    code) != std::end(out_of_estimate);
        if (estimate_short && instance->control(14) < most_percent)
          {
            instance->control(14) *= 2;
            continue;
          }
        AssertThrow(code != -10,
                    ExcNotConverged("The tangent matrix is singular."));
        AssertThrow(
          code != -13,
          ExcSolveFailed(
            "The direct solver ran out of memory. Use a coarser mesh, "
            "more ranks on more machines, or a smaller problem."));
        AssertThrow(false,
                    ExcSolveFailed("The factorisation by MUMPS failed with "
                                   "code " +
                                   std::to_string(code) + ", " +
                                   std::to_string(instance->info(2)) + "."));
      }
  }



  void
  Mumps::read_pattern(const Matrix &A)
  {
    rows.clear();
    columns.clear();
    for_each_entry(A,
                   symmetric,
                   [&](const int row, const int column, const double) {
                     rows.push_back(row + 1);
                     columns.push_back(column + 1);
                   });
    values.resize(rows.size());

    DMUMPS_STRUC_C &data = instance->data;
    data.n               = A.m();
    data.nnz_loc         = rows.size();
    data.irn_loc         = rows.data();
    data.jcn_loc         = columns.data();
    data.a_loc           = values.data();

    counts =
      dealii::Utilities::MPI::all_gather(comm,
                                         static_cast<int>(A.local_size()));
    offsets = counts;
    for (unsigned int r = 0, sum = 0; r < counts.size(); ++r)
      {
        offsets[r] = sum;
        sum += counts[r];
      }
    if (dealii::Utilities::MPI::this_mpi_process(comm) == 0)
      centralised.resize(A.m());
  }



  void
  Mumps::read_values(const Matrix &A)
  {
    std::size_t e = 0;
    for_each_entry(A, symmetric, [&](const int, const int, const double value) {
      values[e++] = value;
    });
    Assert(e == values.size(), dealii::ExcInternalError());
  }



  void
  Mumps::solve(Vector &x, const Vector &b)
  {
    // The right-hand side and the solution are whole on rank 0.
    const int n_local = b.locally_owned_size();
    MPI_Gatherv(b.begin(),
                n_local,
                MPI_DOUBLE,
                centralised.data(),
                counts.data(),
                offsets.data(),
                MPI_DOUBLE,
                0,
                comm);
    instance->data.rhs = centralised.data();
    run(back_substitute);
    AssertThrow(instance->info(1) >= 0,
                ExcSolveFailed("The back substitution by MUMPS failed with "
                               "code " +
                               std::to_string(instance->info(1)) + "."));
    MPI_Scatterv(centralised.data(),
                 counts.data(),
                 offsets.data(),
                 MPI_DOUBLE,
                 x.begin(),
                 n_local,
                 MPI_DOUBLE,
                 0,
                 comm);
  }



  int
  Mumps::memory_in_megabytes() const
  {
    return instance->info(21);
  }
} // namespace lumbricus
