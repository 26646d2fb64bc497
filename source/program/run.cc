// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/checkpoint/checkpoint_folders.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/interruption.h>
#include <lumbricus/core/log.h>
#include <lumbricus/core/out_of_memory.h>
#include <lumbricus/output/earlier_run.h>
#include <lumbricus/output/run_description.h>
#include <lumbricus/parameters/entries_as_json.h>
#include <lumbricus/program/blas.h>
#include <lumbricus/program/run.h>

#include <deal.II/base/mpi.h>

#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "chain_problem.h"
#include "expected_accuracy.h"
#include "memory_end.h"
#include "run_input.h"

namespace lumbricus
{
  namespace
  {
    const std::string log_name = "log.txt";



    // That the results cannot even be begun is no failure of a solve.
    template <typename Write>
    void
    begin_results(const Write &write)
    {
      std::string reason;
      try
        {
          write();
        }
      catch (const ExcSolveFailed &exception)
        {
          reason = plain_message(exception);
        }
      AssertThrow(reason.empty(),
                  ExcInput(reason +
                           " Nothing was computed. See that it may be "
                           "written, or choose another folder with "
                           "'Output/Folder' or --output."));
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



    // A run that not all ranks have left together ends here, before objects are
    // destroyed that need all ranks for it.
    void
    abort_unless_foreseen(const std::exception &exception, const MPI_Comm comm)
    {
      const auto *foreseen =
        dynamic_cast<const dealii::ExceptionBase *>(&exception);
      if (foreseen == nullptr ||
          !(is_thrown_on_all_ranks(*foreseen) ||
            dynamic_cast<const ExcInterrupted *>(foreseen) != nullptr))
        abort_on_bug(exception, comm);
    }



    // How a run that came to @p status has ended, by what was foreseen.
    RunStatus
    ended(RunStatus status, const std::exception &exception)
    {
      status.state =
        dynamic_cast<const ExcInterrupted *>(&exception) != nullptr ?
          RunStatus::State::interrupted :
          RunStatus::State::failed;
      status.message =
        plain_message(dynamic_cast<const dealii::ExceptionBase &>(exception));
      return status;
    }



    void
    set_up(ChainProblem &problem, const RunInput &input, const MPI_Comm comm)
    {
      end_all_ranks_when_memory_ends(comm);
      try
        {
          with_memory_message(comm, [&]() {
            reserve_blas_memory();
            problem.setup(input.checkpoint.get());
          });
        }
      catch (const std::exception &exception)
        {
          abort_unless_foreseen(exception, comm);
          throw;
        }
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



    // What goes into run.json before the run begins.
    RunDescription
    describe(const RunInput              &input,
             const ParameterFile::Values &places,
             const ChainProblem          &problem,
             const MPI_Comm               comm)
    {
      const RunParameters &parameters = input.parameters;
      RunDescription       description(*input.folder);
      description.describe_run(parameters.title,
                               dealii::Utilities::MPI::n_mpi_processes(comm));
      if (input.restarts())
        description.describe_restart(input.checkpoint->program_version(),
                                     input.checkpoint->progress().step,
                                     input.checkpoint->progress().time);
      description.describe_body(parameters.anatomy,
                                parameters.boundary_conditions,
                                problem.mesh());
      description.describe_body_forces(parameters.body_forces);
      description.describe_parameters(input.file.entries(places));
      return description;
    }



    // See whether all results can be written, then change files for the first
    // time.
    RunDescription
    begin(const RunInput   &input,
          const RunRequest &request,
          ChainProblem     &problem,
          Log              &log,
          const MPI_Comm    comm)
    {
      RunFolder                  &folder = *input.folder;
      const ParameterFile::Values places = input.places(request.input_files);
      for (const std::string &name : {log_name, Manifest::parameters})
        folder.claim(name);
      RunDescription description = describe(input, places, problem, comm);
      problem.prepare(folder, input.checkpoint.get());
      leave_if_interrupted_before_begin(comm);
      begin_results([&]() {
        begin_folder(
          folder, log, input.resolved(places), !input.restarts(), comm);
        description.write(problem.status());
      });
      return description;
    }



    void
    say_what_runs(const RunInput &input, ChainProblem &problem, Log &log)
    {
      std::ostringstream version;
      print_version(version);
      log << version.str() << blas_warning() << input.skipped_checkpoints;
      if (input.restarts() &&
          input.checkpoint->program_version() != LUMBRICUS_VERSION)
        log << "The checkpoint was written by version "
            << input.checkpoint->program_version() << ".\n";
      for (const std::string &name : input.file.unused())
        log << "Not used, because of --set: " << name << ".\n";
      problem.describe();
    }



    // What errors to expect, where runs have left their estimates in the folder
    // of results or beside it. A run that goes on has its own.
    void
    say_expected_accuracy(const RunInput     &input,
                          const ChainProblem &problem,
                          Log                &log,
                          const MPI_Comm      comm)
    {
      if (input.restarts() ||
          dealii::Utilities::MPI::this_mpi_process(comm) != 0)
        return;
      const std::string &folder = input.parameters.output_folder;
      const std::vector<EarlierRun> runs = earlier_runs(folder);
      if (!runs.empty())
        log << expected_accuracy(
          values_of(input.file.entries(input.places(input.file.input_files()))),
          problem.n_unknowns(),
          folder,
          runs);
    }



    // All parameters with their values, for other programs.
    void
    say_values(const RunInput &input, const MPI_Comm comm)
    {
      std::string reason;
      if (dealii::Utilities::MPI::this_mpi_process(comm) == 0)
        {
          as_json(input.file.entries()).write(std::cout);
          std::cout << '\n';
          if (!std::cout.flush())
            reason = Log::output_cannot_be_written;
        }
      throw_on_all_ranks<ExcInput>(reason, comm);
    }



    void
    compute(ChainProblem         &problem,
            const RunInput       &input,
            const RunRequest     &request,
            const RunDescription &description,
            const MPI_Comm        comm)
    {
      try
        {
          begin_results([&]() { problem.begin(input.checkpoint.get()); });
          problem.run(*input.folder, request);
        }
      catch (const std::exception &exception)
        {
          abort_unless_foreseen(exception, comm);
          description.try_to_write(ended(problem.status(), exception));
          throw;
        }
      RunStatus status = problem.status();
      status.state     = RunStatus::State::finished;
      description.write(status);
    }
  } // namespace



  void
  run(const CommandLine &command_line, const MPI_Comm comm)
  {
    RunInput input(command_line, comm);
    Log      log(comm,
            command_line.quiet,
            command_line.verbose,
            command_line.progress);
    if (input.is_over())
      {
        log << "The run in '" << command_line.restart_folder
            << "' has come to its end, time "
            << input.checkpoint->progress().time
            << ". No file was changed. To make it longer add --set "
               "Time/End=...\n";
        return;
      }
    if (!command_line.check)
      input.open_folder();
    leave_if_interrupted_before_begin(comm);

    ChainProblem problem(input.parameters, log, comm);
    set_up(problem, input, comm);
    if (command_line.check)
      {
        if (command_line.values)
          {
            say_values(input, comm);
            return;
          }
        say_what_runs(input, problem, log);
        say_expected_accuracy(input, problem, log, comm);
        log << "The input is valid; nothing was computed.\n";
        // What was said is all that a check gives.
        throw_on_all_ranks<ExcInput>(log.lost_output(), comm);
        return;
      }

    const RunRequest     request = input.request();
    const RunDescription description =
      begin(input, request, problem, log, comm);
    say_what_runs(input, problem, log);
    compute(problem, input, request, description, comm);
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
