// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/checkpoint/checkpoint_folders.h>
#include <lumbricus/checkpoint/manifest.h>
#include <lumbricus/core/exceptions.h>

#include <deal.II/base/utilities.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace lumbricus
{
  namespace
  {
    namespace files = std::filesystem;

    const std::string all_checkpoints = "checkpoints";

    // Numbers of more digits are the larger ones.
    bool
    is_newer(const std::string &name, const std::string &other)
    {
      return name.size() != other.size() ? name.size() > other.size() :
                                           name > other;
    }



    bool
    is_complete(const files::path &checkpoint)
    {
      std::error_code error;
      return files::is_regular_file(
        files::symlink_status(checkpoint / Manifest::file_name, error));
    }



    // Whether the program writes files of this name there, also for a while.
    bool
    is_ours(const std::string &name)
    {
      const std::string ending = ".incomplete";
      const auto        n      = name.size() - ending.size();
      return Manifest::is_name_of_a_file(
        name.size() > ending.size() && name.substr(n) == ending ?
          name.substr(0, n) :
          name);
    }



    std::vector<files::path>
    our_files_in(const files::path &checkpoint)
    {
      std::vector<files::path> ours;
      std::error_code          error;
      for (files::directory_iterator entry(checkpoint, error), end;
           !error && entry != end;
           entry.increment(error))
        if (is_ours(entry->path().filename().string()))
          ours.push_back(entry->path());
      return ours;
    }
  } // namespace



  std::string
  checkpoint_name(const unsigned int step)
  {
    return dealii::Utilities::to_string(step, 6);
  }



  std::string
  checkpoint_in_folder(const std::string &name)
  {
    return all_checkpoints + "/" + name;
  }



  std::string
  checkpoint_path(const RunFolder &folder, const std::string &name)
  {
    return folder.path() + "/" + checkpoint_in_folder(name);
  }



  std::vector<std::string>
  checkpoints_of(const RunFolder &folder)
  {
    std::vector<std::string> names;
    for (const std::string &name : folder.record().checkpoints())
      {
        std::error_code error;
        if (files::is_directory(
              files::symlink_status(checkpoint_path(folder, name), error)))
          names.push_back(name);
      }
    std::sort(names.begin(), names.end(), is_newer);
    return names;
  }



  void
  make_checkpoint_folder(const RunFolder &folder, const std::string &name)
  {
    const std::string path     = checkpoint_path(folder, name);
    const bool        recorded = folder.record().checkpoints().count(name) > 0;
    std::error_code   error;
    const auto        status = files::symlink_status(path, error);
    AssertThrow(!files::exists(status) ||
                  (files::is_directory(status) &&
                   (recorded || our_files_in(path).empty())),
                ExcSolveFailed("The folder '" + path +
                               "' cannot be made: something is there that is "
                               "not from this run. Move it away."));
    folder.record().add_checkpoint(name);
    remove_checkpoint(folder, name);
    files::create_directories(path, error);
    AssertThrow(!error,
                ExcSolveFailed("The folder '" + path +
                               "' cannot be made: " + error.message() + "."));
  }



  void
  remove_checkpoint(const RunFolder &folder, const std::string &name)
  {
    const std::string path = checkpoint_path(folder, name);
    std::error_code   error;
    if (!files::is_directory(files::symlink_status(path, error)))
      return;
    // First that without which it does not count.
    unlink((path + "/" + Manifest::file_name).c_str());
    for (const files::path &file : our_files_in(path))
      unlink(file.c_str());
    rmdir(path.c_str());
  }



  void
  remove_checkpoints(const RunFolder &folder)
  {
    for (const std::string &name : checkpoints_of(folder))
      {
        remove_checkpoint(folder, name);
        AssertThrow(!is_complete(checkpoint_path(folder, name)),
                    ExcSolveFailed("The checkpoint '" +
                                   checkpoint_path(folder, name) +
                                   "', of an earlier run, cannot be "
                                   "removed."));
      }
    // Where nothing else is in it.
    rmdir((folder.path() + "/" + all_checkpoints).c_str());
  }



  void
  remove_old_checkpoints(const RunFolder &folder, const std::string &current)
  {
    bool kept = false;
    for (const std::string &name : checkpoints_of(folder))
      {
        const bool older = is_newer(current, name);
        if (name == current ||
            (older && !kept && is_complete(checkpoint_path(folder, name))))
          {
            kept = kept || older;
            continue;
          }
        remove_checkpoint(folder, name);
      }
  }
} // namespace lumbricus
