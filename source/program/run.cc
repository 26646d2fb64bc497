// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/interruption.h>
#include <lumbricus/core/parameter_file.h>
#include <lumbricus/program/blas.h>
#include <lumbricus/program/chain_problem.h>
#include <lumbricus/program/run.h>

#include <deal.II/base/utilities.h>

#include <functional>
#include <iostream>
#include <memory>
#include <sstream>

namespace lumbricus
{
  namespace
  {
    // What a run that goes on cannot change: its state hangs on it.
    const std::string kept_at_restart[] = {"Geometry",
                                           "Mesh",
                                           "Tissues",
                                           "Interface",
                                           "Reset/Mode",
                                           "Output/Folder",
                                           "Output/Points"};

    void
    check_restart_setting(const std::string &untrimmed)
    {
      const std::string setting = dealii::Utilities::trim(untrimmed);
      for (const std::string &kept : kept_at_restart)
        {
          const auto end = setting.find_first_of("/= ", kept.size());
          AssertThrow(setting.compare(0, kept.size(), kept) != 0 ||
                        end != kept.size(),
                      ExcInput("The setting '" + setting +
                               "' cannot change at a restart, because the "
                               "state hangs on it. Leave it out, or start the "
                               "run from its parameter file."));
        }
    }



    // That the results cannot even be begun is no failure of a solve.
    template <typename Write>
    void
    begin_results(const Write &write, const std::function<bool()> &has_begun)
    {
      try
        {
          write();
        }
      catch (const ExcSolveFailed &exception)
        {
          if (has_begun())
            throw;
          AssertThrow(false,
                      ExcInput(plain_message(exception) +
                               " Nothing was computed. See that it may be "
                               "written, or choose another folder with "
                               "'Output/Folder' or --output."));
        }
    }



    void
    write_parameters(const RunFolder   &folder,
                     const std::string &resolved,
                     const MPI_Comm     comm)
    {
      folder.write_collectively("parameters.prm",
                                dealii::Utilities::MPI::this_mpi_process(
                                  comm) == 0,
                                [&](std::ostream &out) { out << resolved; });
    }
  } // namespace



  void
  run(const CommandLine &command_line, const MPI_Comm comm)
  {
    std::unique_ptr<Checkpoint> checkpoint;
    std::string                 skipped;
    if (!command_line.restart_folder.empty())
      {
        checkpoint = std::make_unique<Checkpoint>(
          Checkpoint::newest(command_line.restart_folder, skipped, comm));
        for (const std::string &setting : command_line.settings)
          check_restart_setting(setting);
      }

    ParameterFile file;
    RunParameters parameters;
    file.read(checkpoint != nullptr ? checkpoint->parameter_file() :
                                      command_line.parameter_file);
    for (const std::string &setting : command_line.settings)
      file.set(setting);
    file.parse(parameters);
    parameters.initialize();
    if (checkpoint != nullptr)
      parameters.output_folder = command_line.restart_folder;
    else if (!command_line.output_folder.empty())
      parameters.output_folder = command_line.output_folder;

    // First see whether results can be written, but leave what is in the folder
    // as it is until the input has turned out to be right.
    std::unique_ptr<RunFolder> folder;
    if (!command_line.check)
      folder = std::make_unique<RunFolder>(parameters.output_folder, comm);

    Log          log(comm,
            command_line.quiet,
            command_line.verbose,
            command_line.progress);
    ChainProblem problem(parameters, log, comm);
    problem.setup(checkpoint.get());

    std::ostringstream resolved;
    file.print_resolved(resolved);
    if (folder != nullptr)
      {
        begin_results(
          [&]() {
            const std::string name   = folder->path() + "/log.txt";
            const std::string reason = log.open(name, checkpoint != nullptr);
            throw_on_all_ranks<ExcSolveFailed>(
              reason.empty() ?
                "" :
                "The file '" + name + "' cannot be written: " + reason + ".",
              comm);
            write_parameters(*folder, resolved.str(), comm);
          },
          []() { return false; });
      }

    std::ostringstream version;
    print_version(version);
    log << version.str() << blas_warning() << skipped;
    if (checkpoint != nullptr &&
        checkpoint->program_version() != LUMBRICUS_VERSION)
      log << "The checkpoint was written by version "
          << checkpoint->program_version() << ".\n";
    problem.describe();
    if (command_line.check)
      log << "The input is valid; nothing was computed.\n";
    else
      try
        {
          begin_results(
            [&]() { problem.run(*folder, resolved.str(), checkpoint.get()); },
            [&]() { return problem.has_begun(); });
        }
      catch (const ExcInput &)
        {
          throw;
        }
      catch (const ExcSolveFailed &)
        {
          throw;
        }
      catch (const ExcInterrupted &)
        {
          throw;
        }
      catch (const std::exception &exception)
        {
          // Before the problem is destroyed, which needs all ranks.
          abort_on_bug(exception, comm);
        }
  }



  void
  abort_on_bug(const std::exception &exception, const MPI_Comm comm)
  {
    std::cerr << "\nlumbricus: this is a bug, please report it.\n"
              << exception.what() << std::endl;
    MPI_Abort(comm, ExitCode::bug);
  }
} // namespace lumbricus
