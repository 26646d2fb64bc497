// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/parameter_file.h>
#include <lumbricus/program/blas.h>
#include <lumbricus/program/chain_problem.h>
#include <lumbricus/program/command_line.h>

#include <deal.II/base/mpi.h>

#include <iostream>
#include <memory>
#include <sstream>

namespace
{
  using namespace lumbricus;

  enum ExitCode
  {
    done         = 0,
    wrong_input  = 1,
    solve_failed = 2,
    bug          = 3
  };



  void
  run(const CommandLine &command_line, const MPI_Comm comm)
  {
    ParameterFile file;
    RunParameters parameters;
    file.read(command_line.parameter_file);
    for (const std::string &setting : command_line.settings)
      file.set(setting);
    file.parse(parameters);
    parameters.initialize();
    if (!command_line.output_folder.empty())
      parameters.output_folder = command_line.output_folder;

    // First see whether results can be written, but leave what is in the folder
    // as it is until the input has turned out to be right.
    std::unique_ptr<RunFolder> folder;
    if (!command_line.check)
      folder = std::make_unique<RunFolder>(parameters.output_folder, comm);

    Log          log(comm);
    ChainProblem problem(parameters, log, comm);
    problem.setup();

    if (folder != nullptr)
      {
        log.open(folder->path() + "/log.txt");
        std::ostringstream resolved;
        file.print_resolved(resolved);
        folder->write_collectively(
          "parameters.prm",
          dealii::Utilities::MPI::this_mpi_process(comm) == 0,
          [&](std::ostream &out) { out << resolved.str(); });
      }

    std::ostringstream version;
    print_version(version);
    log << version.str() << blas_warning();
    problem.describe();
    if (command_line.check)
      log << "The input is valid; nothing was computed.\n";
    else
      problem.run(*folder);
  }
} // namespace



int
main(int argc, char *argv[])
{
  prepare_blas(argv);
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  const MPI_Comm comm  = MPI_COMM_WORLD;
  const bool     first = dealii::Utilities::MPI::this_mpi_process(comm) == 0;
  const auto     say   = [&](const std::string &message) {
    if (first)
      std::cerr << "\nlumbricus: " << message << std::endl;
  };

  try
    {
      const CommandLine command_line(argc, argv);
      if (command_line.help || command_line.version || command_line.parameters)
        {
          if (!first)
            return done;
          RunParameters parameters;
          if (command_line.help)
            print_help(std::cout);
          else if (command_line.version)
            print_version(std::cout);
          else
            ParameterFile::print_reference(parameters, std::cout);
          return done;
        }
      run(command_line, comm);
      return done;
    }
  catch (const ExcInput &exception)
    {
      say(plain_message(exception));
      return wrong_input;
    }
  catch (const ExcSolveFailed &exception)
    {
      say(plain_message(exception));
      return solve_failed;
    }
  catch (const std::exception &exception)
    {
      // Not foreseen, and perhaps on this rank only: the others must not wait.
      std::cerr << "\nlumbricus: this is a bug, please report it.\n"
                << exception.what() << std::endl;
      MPI_Abort(comm, bug);
      return bug;
    }
}
