// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/checkpoint/checkpoint_folders.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/interruption.h>
#include <lumbricus/core/out_of_memory.h>
#include <lumbricus/core/user_text.h>
#include <lumbricus/output/run_description.h>
#include <lumbricus/parameters/parameter_file.h>
#include <lumbricus/parameters/prm_scanner.h>
#include <lumbricus/program/blas.h>
#include <lumbricus/program/run.h>
#include <lumbricus/program/shared_libraries.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

#include "chain_problem.h"
#include "memory_end.h"

namespace lumbricus
{
  namespace
  {
    const std::string log_name = "log.txt";

    // What a run that goes on cannot change: its state hangs on it.
    const std::string kept_at_restart[] = {"Geometry",
                                           "Mesh",
                                           "Tissues",
                                           "Interface",
                                           "Reset/Mode",
                                           "Output/Folder",
                                           "Output/Format",
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



    // Once begun a run is interrupted at a safe point, with a checkpoint.
    void
    leave_if_interrupted_before_begin(const MPI_Comm comm)
    {
      try
        {
          throw_if_interrupted(comm);
        }
      catch (const ExcInterrupted &exception)
        {
          throw ExcInterrupted(plain_message(exception) +
                               "\nThe run had not begun, and no file was "
                               "changed. Start it again as before.");
        }
    }



    // The parameters of the run that goes on, with files that are where they
    // were where they are not found from the working directory.
    void
    take_parameters(ParameterFile     &file,
                    const Checkpoint  &checkpoint,
                    const CommandLine &command_line,
                    const MPI_Comm     comm)
    {
      file.take_resolved(checkpoint.path() + "/" + Manifest::parameters,
                         checkpoint.request().parameters);
      std::set<std::string> set_anew;
      for (const std::string &setting : command_line.settings)
        set_anew.insert(ParameterFile::path_of_setting(setting));

      std::map<std::string, std::vector<std::string>> names;
      std::string                                     reason;
      for (const InputFile &input : checkpoint.request().input_files)
        if (set_anew.count(input.parameter) == 0 && reason.empty())
          try
            {
              names[input.parameter].push_back(find_again(input));
            }
          catch (const ExcInput &exception)
            {
              reason = plain_message(exception);
            }
      throw_on_all_ranks<ExcInput>(reason, comm);
      for (const auto &[parameter, of_parameter] : names)
        {
          std::string list;
          for (const std::string &name : of_parameter)
            list += (list.empty() ? "" : ", ") + name;
          file.set(parameter + "=" + list);
        }
    }



    // Whether the run that is asked to go on has come to its end, with all
    // files.
    bool
    is_over(const RunProgress &progress, const LoadStepping &stepping)
    {
      if (!stepping.finished(progress.time))
        return false;
      std::ostringstream message;
      message << "is " << stepping.end_time()
              << ", but the run that is to go on has come to time "
              << progress.time
              << " already. Give a later end, or start the run from its "
                 "parameter file.";
      AssertThrow(progress.time <= stepping.end_time() * (1. + 1e-12),
                  ExcParameter("Time/End", message.str()));
      return progress.picture_is_current;
    }



    // Where files and folders are, by parameter, so that parameters.prm runs
    // the run again from anywhere, into its folder. What a parameter file
    // cannot hold stays as the user wrote it.
    ParameterFile::Values
    places_to_run_again(const std::vector<InputFile> &input_files,
                        const std::string            &output_folder)
    {
      const auto fits = [](const std::string &path) {
        return !path.empty() && is_utf8(path) && unfit_for_a_line(path).empty();
      };
      ParameterFile::Values places;
      std::set<std::string> unfit;
      for (const InputFile &file : input_files)
        {
          std::string &list = places[file.parameter];
          list += (list.empty() ? "" : ", ") + file.path;
          if (!fits(file.path) || file.path.find(',') != std::string::npos)
            unfit.insert(file.parameter);
        }
      for (const std::string &parameter : unfit)
        places.erase(parameter);

      std::error_code   error;
      const std::string folder =
        std::filesystem::canonical(output_folder, error).string();
      if (fits(folder))
        places["Output/Folder"] = folder;
      return places;
    }



    // How a run has ended that came to @p status, by what all ranks have
    // thrown; it is still running where that is none of these.
    RunStatus
    ended(RunStatus status, const std::exception &exception)
    {
      const auto *foreseen =
        dynamic_cast<const dealii::ExceptionBase *>(&exception);
      if (dynamic_cast<const ExcInterrupted *>(&exception) != nullptr)
        status.state = RunStatus::State::interrupted;
      else if (foreseen != nullptr && is_thrown_on_all_ranks(*foreseen))
        status.state = RunStatus::State::failed;
      if (status.state != RunStatus::State::running)
        status.message = plain_message(*foreseen);
      return status;
    }



    // The first that changes files in the folder. @p resolved is for
    // parameters.prm.
    void
    begin_folder(RunFolder         &folder,
                 Log               &log,
                 const std::string &resolved,
                 const bool         fresh,
                 const MPI_Comm     comm)
    {
      if (fresh)
        folder.on_first_rank([&]() { remove_checkpoints(folder); });
      folder.begin(fresh);

      const std::string name   = folder.path() + "/" + log_name;
      const std::string reason = log.open(name, !fresh);
      throw_on_all_ranks<ExcSolveFailed>(
        reason.empty() ?
          "" :
          "The file '" + name + "' cannot be written: " + reason + ".",
        comm);
      folder.on_first_rank([&]() {
        folder.record().add_parameters(fingerprint(resolved));
        folder.write(Manifest::parameters,
                     [&](std::ostream &out) { out << resolved; });
      });
    }
  } // namespace



  void
  run(const CommandLine &command_line, const MPI_Comm comm)
  {
    const bool                  restart = !command_line.restart_folder.empty();
    std::unique_ptr<RunFolder>  folder;
    std::unique_ptr<Checkpoint> checkpoint;
    std::string                 skipped;
    if (restart)
      {
        Checkpoint::check_folder(command_line.restart_folder, comm);
        folder =
          std::make_unique<RunFolder>(command_line.restart_folder,
                                      command_line.check ?
                                        RunFolder::Use::look :
                                        RunFolder::Use::restart,
                                      comm);
        checkpoint = std::make_unique<Checkpoint>(
          Checkpoint::newest(*folder, skipped, comm));
        for (const std::string &setting : command_line.settings)
          check_restart_setting(setting);
      }

    ParameterFile file;
    RunParameters parameters;
    if (restart)
      take_parameters(file, *checkpoint, command_line, comm);
    else
      file.read(command_line.parameter_file);
    for (const std::string &setting : command_line.settings)
      file.set(setting);
    load_shared_libraries(file, comm);
    file.parse(parameters);
    parameters.initialize();
    if (restart)
      parameters.output_folder = command_line.restart_folder;
    else if (!command_line.output_folder.empty())
      parameters.output_folder = command_line.output_folder;

    Log log(comm,
            command_line.quiet,
            command_line.verbose,
            command_line.progress);
    if (restart && is_over(checkpoint->progress(), parameters.load_stepping))
      {
        log << "The run in '" << command_line.restart_folder
            << "' has come to its end, time " << checkpoint->progress().time
            << ". No file was changed. To make it longer add --set "
               "Time/End=...\n";
        return;
      }

    // First see whether results can be written, but leave what is in the folder
    // as it is until the input has turned out to be right.
    if (!command_line.check && !restart)
      folder = std::make_unique<RunFolder>(parameters.output_folder,
                                           RunFolder::Use::write,
                                           comm);
    leave_if_interrupted_before_begin(comm);

    ChainProblem problem(parameters, log, comm);
    end_all_ranks_when_memory_ends(comm);
    try
      {
        with_memory_message(comm, [&]() {
          reserve_blas_memory();
          problem.setup(checkpoint.get());
        });
      }
    catch (const std::exception &exception)
      {
        if (is_out_of_memory(exception))
          abort_out_of_memory(exception, comm);
        throw;
      }

    std::ostringstream resolved;
    file.print_resolved(resolved);
    RunRequest request;
    request.parameters = resolved.str();
    std::unique_ptr<RunDescription> description;
    if (!command_line.check)
      {
        request.input_files = file.input_files();
        const ParameterFile::Values places =
          places_to_run_again(request.input_files, parameters.output_folder);
        std::ostringstream to_run_again;
        file.print_resolved(to_run_again, places);
        for (const std::string &name : {log_name, Manifest::parameters})
          folder->claim(name);
        description = std::make_unique<RunDescription>(*folder);
        description->describe_run(
          parameters.title, dealii::Utilities::MPI::n_mpi_processes(comm));
        if (restart)
          description->describe_restart(checkpoint->program_version(),
                                        checkpoint->progress().step,
                                        checkpoint->progress().time);
        description->describe_body(parameters.anatomy,
                                   parameters.boundary_conditions,
                                   problem.mesh());
        description->describe_body_forces(parameters.body_forces);
        description->describe_parameters(file.entries(places));
        problem.prepare(*folder, checkpoint.get());
        leave_if_interrupted_before_begin(comm);
        begin_results(
          [&]() {
            begin_folder(*folder, log, to_run_again.str(), !restart, comm);
            description->write(problem.status());
          },
          []() { return false; });
      }

    std::ostringstream version;
    print_version(version);
    log << version.str() << blas_warning() << skipped;
    if (restart && checkpoint->program_version() != LUMBRICUS_VERSION)
      log << "The checkpoint was written by version "
          << checkpoint->program_version() << ".\n";
    for (const std::string &name : file.unused())
      log << "Not used, because of --set: " << name << ".\n";
    problem.describe();
    if (command_line.check)
      {
        log << "The input is valid; nothing was computed.\n";
        // This is all there is of it.
        throw_on_all_ranks<ExcInput>(log.lost_output(), comm);
      }
    else
      {
        RunStatus status;
        try
          {
            begin_results(
              [&]() { problem.run(*folder, request, checkpoint.get()); },
              [&]() { return problem.has_begun(); });
          }
        catch (const std::exception &exception)
          {
            status = ended(problem.status(), exception);
            // Before the problem is destroyed, which needs all ranks.
            if (status.state == RunStatus::State::running)
              abort_on_bug(exception, comm);
            description->try_to_write(status);
            throw;
          }
        status       = problem.status();
        status.state = RunStatus::State::finished;
        description->write(status);
      }
  }



  void
  abort_on_bug(const std::exception &exception, const MPI_Comm comm)
  {
    if (is_out_of_memory(exception))
      abort_out_of_memory(exception, comm);
    std::cerr << "\nlumbricus: this is a bug, please report it.\n"
              << exception.what() << std::endl;
    MPI_Abort(comm, ExitCode::bug);
  }
} // namespace lumbricus
