// SPDX-License-Identifier: LGPL-2.1-or-later
#include "run_input.h"

#include <lumbricus/checkpoint/checkpoint_folders.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/user_text.h>
#include <lumbricus/parameters/prm_scanner.h>
#include <lumbricus/program/shared_libraries.h>

#include <deal.II/base/utilities.h>

#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <system_error>
#include <vector>

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
  } // namespace



  RunInput::RunInput(const CommandLine &command_line, const MPI_Comm comm)
    : command_line(command_line)
    , comm(comm)
  {
    if (restarts())
      {
        read_checkpoint();
        for (const std::string &setting : command_line.settings)
          check_restart_setting(setting);
        take_parameters();
      }
    else
      file.read(command_line.parameter_file);
    for (const std::string &setting : command_line.settings)
      file.set(setting);
    load_shared_libraries(file, comm);
    file.parse(parameters);
    parameters.initialize();
    if (restarts())
      parameters.output_folder = command_line.restart_folder;
    else if (!command_line.output_folder.empty())
      parameters.output_folder = command_line.output_folder;
  }



  bool
  RunInput::restarts() const
  {
    return !command_line.restart_folder.empty();
  }



  void
  RunInput::read_checkpoint()
  {
    Checkpoint::check_folder(command_line.restart_folder, comm);
    folder = std::make_unique<RunFolder>(command_line.restart_folder,
                                         command_line.check ?
                                           RunFolder::Use::look :
                                           RunFolder::Use::restart,
                                         comm);
    checkpoint = std::make_unique<Checkpoint>(
      Checkpoint::newest(*folder, skipped_checkpoints, comm));
  }



  void
  RunInput::take_parameters()
  {
    file.take_resolved(checkpoint->path() + "/" + Manifest::parameters,
                       checkpoint->request().parameters);
    std::set<std::string> set_anew;
    for (const std::string &setting : command_line.settings)
      set_anew.insert(ParameterFile::path_of_setting(setting));

    std::map<std::string, std::vector<std::string>> names;
    std::string                                     reason;
    for (const InputFile &input : checkpoint->request().input_files)
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



  bool
  RunInput::is_over() const
  {
    if (!restarts())
      return false;
    const RunProgress  &progress = checkpoint->progress();
    const LoadStepping &stepping = parameters.load_stepping;
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



  void
  RunInput::open_folder()
  {
    if (!restarts())
      folder = std::make_unique<RunFolder>(parameters.output_folder,
                                           RunFolder::Use::write,
                                           comm);
  }



  std::string
  RunInput::resolved(const ParameterFile::Values &instead) const
  {
    std::ostringstream text;
    file.print_resolved(text, instead);
    return text.str();
  }



  RunRequest
  RunInput::request() const
  {
    RunRequest request;
    request.parameters  = resolved();
    request.input_files = file.input_files();
    return request;
  }



  ParameterFile::Values
  RunInput::places(const std::vector<InputFile> &input_files) const
  {
    const auto fits = [](const std::string &path) {
      return !path.empty() && is_utf8(path) && unfit_for_a_line(path).empty();
    };
    ParameterFile::Values places;
    std::set<std::string> unfit;
    for (const InputFile &input : input_files)
      {
        std::string &list = places[input.parameter];
        list += (list.empty() ? "" : ", ") + input.path;
        if (!fits(input.path) || input.path.find(',') != std::string::npos)
          unfit.insert(input.parameter);
      }
    for (const std::string &parameter : unfit)
      places.erase(parameter);

    std::error_code   error;
    const std::string folder =
      std::filesystem::canonical(parameters.output_folder, error).string();
    if (fits(folder))
      places["Output/Folder"] = folder;
    return places;
  }
} // namespace lumbricus
