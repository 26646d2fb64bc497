// SPDX-License-Identifier: LGPL-2.1-or-later
// What a rank sends in a linear iteration: benchmark_messages CASE [SETTING ...].
// The first linear system of a load step is solved twice with the same factors, to
// two tolerances. What is sent more often for the better one is that of the
// iterations that it takes more.
#include <lumbricus/core/mpi_session.h>
#include <lumbricus/parameters/parameter_file.h>
#include <lumbricus/program/blas.h>
#include <lumbricus/program/chain_model.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/timer.h>

#include <array>
#include <exception>
#include <iostream>
#include <utility>
#include <vector>

#include "count_messages.h"

using namespace lumbricus;

namespace
{
  // For each of @p n iterations: the mean over the ranks, and the most of one.
  void
  print(const Sent &of_all, const unsigned int n, const MPI_Comm comm)
  {
    constexpr std::array<const char *, 6> names = {{"messages",
                                                  "bytes",
                                                  "collectives",
                                                  "collective_bytes",
                                                  "shared",
                                                  "shared_bytes"}};
    std::vector<double> each = {of_all.messages,
                                of_all.bytes,
                                of_all.collectives,
                                of_all.collective_bytes,
                                of_all.shared,
                                of_all.shared_bytes};
    for (double &number : each)
      number /= n;
    const auto of_ranks = dealii::Utilities::MPI::min_max_avg(each, comm);
    if (dealii::Utilities::MPI::this_mpi_process(comm) == 0)
      for (unsigned int k = 0; k < names.size(); ++k)
        std::cout << names[k] << " " << of_ranks[k].avg << " "
                  << of_ranks[k].max << "\n";
  }



  void
  measure(const int argc, char *const argv[])
  {
    const MPI_Comm comm = MPI_COMM_WORLD;
    ParameterFile  file;
    file.read(argv[1]);
    for (int k = 2; k < argc; ++k)
      file.set(argv[k]);
    RunParameters parameters;
    file.parse(parameters);
    parameters.initialize();
    dealii::TimerOutput timer(std::cout,
                              dealii::TimerOutput::never,
                              dealii::TimerOutput::wall_times);
    ChainModel          model(parameters, timer, comm);
    model.create(nullptr);
    State state = model.rest_state();
    state.time  = 0.05;
    model.set_to(state);
    model.equilibrium.linearise({state.solution, state.globals});

    Unknowns    dx{state.solution, state.globals};
    const auto &counts = parameters.linear_solver->statistics();
    model.equilibrium.solve(dx, 1e-2); // factors are made
    const auto solve = [&](const double tolerance) {
      const Sent         before     = sent;
      const unsigned int n          = counts.n_iterations;
      const unsigned int n_factored = counts.n_factorisations;
      model.equilibrium.solve(dx, tolerance);
      AssertThrow(counts.n_factorisations == n_factored,
                  dealii::ExcMessage("The factors were not kept."));
      return std::make_pair(sent - before, counts.n_iterations - n);
    };
    const auto few  = solve(1e-2);
    const auto many = solve(1e-5);
    if (dealii::Utilities::MPI::this_mpi_process(comm) == 0)
      std::cout << "unknowns " << model.space.dof_handler.n_dofs()
                << "\niterations " << few.second << " " << many.second << "\n";
    print(many.first - few.first, many.second - few.second, comm);
  }
} // namespace



int
main(int argc, char *argv[])
{
  prepare_blas(argv);
  try
    {
      const MpiSession session(argv[0]);
      measure(argc, argv);
    }
  catch (const std::exception &exception)
    {
      std::cerr << exception.what() << "\n";
      MPI_Abort(MPI_COMM_WORLD, 1);
    }
  return 0;
}
