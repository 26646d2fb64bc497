// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/interruption.h>
#include <lumbricus/core/mpi_session.h>
#include <lumbricus/core/parameter_file.h>
#include <lumbricus/program/blas.h>
#include <lumbricus/program/run.h>
#include <lumbricus/program/run_parameters.h>
#include <lumbricus/program/run_program.h>

#include <deal.II/base/mpi.h>

#include <iostream>

namespace lumbricus
{
  int
  run_program(int argc, char *argv[])
  {
    prepare_blas(argv);
    const MpiSession session(argv[0]);

    const MPI_Comm comm  = MPI_COMM_WORLD;
    const bool     first = dealii::Utilities::MPI::this_mpi_process(comm) == 0;
    const auto     say   = [&](const std::string &message) {
      if (first)
        std::cerr << "\nlumbricus: " << message << std::endl;
    };

    try
      {
        const CommandLine command_line(argc, argv);
        if (command_line.help || command_line.version ||
            command_line.parameters)
          {
            if (!first)
              return ExitCode::done;
            RunParameters parameters;
            if (command_line.help)
              print_help(std::cout);
            else if (command_line.version)
              print_version(std::cout);
            else
              ParameterFile::print_reference(parameters, std::cout);
            return ExitCode::done;
          }
        watch_for_interruption();
        run(command_line, comm);
        return ExitCode::done;
      }
    catch (const ExcInput &exception)
      {
        say(plain_message(exception));
        return ExitCode::wrong_input;
      }
    catch (const ExcSolveFailed &exception)
      {
        say(plain_message(exception));
        return ExitCode::solve_failed;
      }
    catch (const ExcInterrupted &exception)
      {
        say(plain_message(exception));
        return ExitCode::interrupted;
      }
    catch (const std::exception &exception)
      {
        // Not foreseen, and perhaps on this rank only: the others must not
        // wait.
        abort_on_bug(exception, comm);
        return ExitCode::bug;
      }
  }
} // namespace lumbricus
