// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/input_limits.h>
#include <lumbricus/core/interruption.h>
#include <lumbricus/core/log.h>
#include <lumbricus/core/mpi_session.h>
#include <lumbricus/core/user_text.h>
#include <lumbricus/parameters/parameter_file.h>
#include <lumbricus/program/blas.h>
#include <lumbricus/program/run.h>
#include <lumbricus/program/run_parameters.h>
#include <lumbricus/program/run_program.h>
#include <lumbricus/program/shared_libraries.h>

#include <deal.II/base/mpi.h>

#include <fcntl.h>
#include <unistd.h>

#include <iostream>

namespace lumbricus
{
  namespace
  {
    // A standard stream that was closed is opened so that its use fails: else
    // the first file that is opened takes its place, and what is said goes
    // there.
    void
    occupy_closed_streams()
    {
      for (int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(stream, F_GETFD) == -1 &&
            open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY) !=
              stream)
          return;
    }



    // All parameters there are, with those of the libraries that a file or a
    // setting names.
    void
    print_parameters(const CommandLine &command_line, const MPI_Comm comm)
    {
      ParameterFile file;
      if (!command_line.parameter_file.empty())
        file.read(command_line.parameter_file);
      for (const std::string &setting : command_line.settings)
        file.set(setting);
      load_shared_libraries(file, comm);
      RunParameters parameters;
      if (dealii::Utilities::MPI::this_mpi_process(comm) == 0)
        ParameterFile::print_reference(parameters, std::cout);
    }



    // What was said on standard output, which users asked for, has to be there.
    void
    check_said()
    {
      AssertThrow(std::cout.flush(), ExcInput(Log::output_cannot_be_written));
    }
  } // namespace



  int
  run_program(int argc, char *argv[])
  {
    occupy_closed_streams();
    // What is ignored stays so where the program starts itself anew.
    watch_for_interruption();
    prepare_blas(argv);
    const MpiSession session(argv[0]);
    // PETSc leaves none of them.
    watch_for_interruption();

    const MPI_Comm comm  = MPI_COMM_WORLD;
    const bool     first = dealii::Utilities::MPI::this_mpi_process(comm) == 0;
    const auto     say   = [&](const std::string &message) {
      if (first)
        std::cerr << "\nlumbricus: "
                  << printable(message, InputLimits::message) << std::endl;
    };

    try
      {
        check_registrations();
        const CommandLine command_line(argc, argv);
        if (command_line.help || command_line.version ||
            command_line.parameters)
          {
            if (command_line.parameters && !command_line.help &&
                !command_line.version)
              print_parameters(command_line, comm);
            else if (first && command_line.help)
              print_help(std::cout);
            else if (first)
              print_version(std::cout);
            check_said();
            return ExitCode::done;
          }
        ignore_closed_output();
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
