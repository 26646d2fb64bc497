// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/output/run_folder.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace lumbricus
{
  namespace
  {
    namespace files = std::filesystem;

    const std::string parameters     = "parameters.prm";
    const std::string not_whole_yet  = ".incomplete";
    const std::string another_folder = "Move it away, or choose another folder "
                                       "with 'Output/Folder' or --output.";

    // @p name without ".incomplete", where it ends so.
    std::string
    final_name(const std::string &name)
    {
      const auto n = not_whole_yet.size();
      return name.size() > n && name.substr(name.size() - n) == not_whole_yet ?
               name.substr(0, name.size() - n) :
               name;
    }



    bool
    is_regular(const files::path &path)
    {
      std::error_code error;
      return files::is_regular_file(files::symlink_status(path, error));
    }



    // The names of what is in a folder.
    std::vector<std::string>
    names_in(const files::path &path)
    {
      std::vector<std::string> names;
      std::error_code          error;
      for (files::directory_iterator entry(path, error), end;
           !error && entry != end;
           entry.increment(error))
        names.push_back(entry->path().filename().string());
      return names;
    }
  } // namespace



  RunFolder::RunFolder(const std::string &path,
                       const Use          use,
                       const MPI_Comm     comm)
    : folder(path)
    , comm(comm)
    , is_first(dealii::Utilities::MPI::this_mpi_process(comm) == 0)
  {
    std::string reason;
    if (is_first && use == Use::write)
      {
        std::error_code error;
        if (!folder.empty())
          files::create_directories(folder, error);
        if (folder.empty())
          reason = "it has no name.";
        else if (error)
          reason = error.message() + ".";
        if (!reason.empty())
          reason = "The output folder '" + folder +
                   "' cannot be written: " + reason +
                   " Choose another with 'Output/Folder' or --output.";
      }
    throw_on_all_ranks<ExcInput>(reason, comm);
    if (use != Use::look)
      lock = std::make_unique<RunLock>(folder, comm);
    if (is_first)
      try
        {
          run_record.read(folder);
        }
      catch (const ExcInput &exception)
        {
          reason = plain_message(exception);
        }
    throw_on_all_ranks<ExcInput>(reason, comm);
  }



  const std::string &
  RunFolder::path() const
  {
    return folder;
  }



  RunRecord &
  RunFolder::record() const
  {
    return run_record;
  }



  bool
  RunFolder::has_foreign(const std::string &name) const
  {
    const files::path path = files::path(folder) / name;
    std::error_code   error;
    if (!files::exists(files::symlink_status(path, error)))
      return false;
    if (!is_regular(path) || run_record.files().count(final_name(name)) == 0)
      return true;
    if (name != parameters)
      return false;
    // The file that users most likely change, or have put there.
    const auto content = fingerprint_of_file(path.string());
    return !content || !run_record.has_parameters(content->value());
  }



  std::string
  RunFolder::foreign(const std::string &name) const
  {
    return "The file '" + folder + "/" + name +
           "' is not as a run of lumbricus has left it, and would be "
           "overwritten. " +
           another_folder +
           (name == parameters && run_record.files().count(name) > 0 ?
              " A run that goes on takes its parameters from the checkpoint; "
              "--set changes them." :
              "");
  }



  void
  RunFolder::claim(const std::string &name)
  {
    std::string reason;
    if (is_first)
      for (const std::string &possible : {name, name + not_whole_yet})
        if (reason.empty() && has_foreign(possible))
          reason = foreign(possible);
    throw_on_all_ranks<ExcInput>(reason, comm);
    claimed.push_back(name);
  }



  void
  RunFolder::claim_folder(
    const std::string                              &name,
    const std::function<bool(const std::string &)> &is_ours)
  {
    std::string reason;
    if (is_first)
      {
        const files::path path = files::path(folder) / name;
        std::error_code   error;
        files::create_directory(path, error);
        if (!error && access(path.c_str(), W_OK | X_OK) != 0)
          error = std::error_code(errno, std::generic_category());
        if (error)
          reason = "The folder '" + path.string() +
                   "' cannot be written: " + error.message() + ". " +
                   another_folder;
        for (const std::string &present : names_in(path))
          if (reason.empty() && is_ours(final_name(present)) &&
              has_foreign(name + "/" + present))
            reason = foreign(name + "/" + present);
      }
    throw_on_all_ranks<ExcInput>(reason, comm);
  }



  void
  RunFolder::continue_tables(const std::map<std::string, Fingerprint> &sizes)
  {
    const std::string advice =
      " Bring it back, or start the run from its parameter file.";
    std::string reason;
    for (const auto &[name, part] : sizes)
      {
        GrowingFingerprint content;
        if (is_first && reason.empty())
          {
            const std::string file_name = folder + "/" + name;
            std::error_code   error;
            const auto        present = files::file_size(file_name, error);
            if (error || present < part.size)
              reason = "The table '" + file_name +
                       "' is shorter than it was at the checkpoint" +
                       (error ? " (" + error.message() + ")" : "") + "." +
                       advice;
            else if (has_foreign(name))
              reason = "The table '" + file_name +
                       "' is not one that the run has written." + advice;
            else if (const auto found =
                       fingerprint_of_file(file_name, part.size);
                     found && found->value() == part)
              content = *found;
            else
              reason = "The table '" + file_name +
                       "' is not as it was at the checkpoint." + advice;
          }
        continued_tables[name] = content;
      }
    throw_on_all_ranks<ExcInput>(reason, comm);
  }



  bool
  RunFolder::continues(const std::string &name) const
  {
    return continued_tables.count(name) > 0;
  }



  GrowingFingerprint
  RunFolder::content(const std::string &name) const
  {
    return continued_tables.at(name);
  }



  void
  RunFolder::begin(const bool fresh)
  {
    // A table that nobody goes on with cannot be the run's.
    for (const auto &table : continued_tables)
      AssertThrow(std::count(claimed.begin(), claimed.end(), table.first) > 0,
                  ExcInput("The checkpoint in '" + folder +
                           "' has a table '" + table.first +
                           "', which this run does not write. Start the run "
                           "from its parameter file."));
    on_first_rank([&]() {
      if (fresh)
        {
          remove_earlier_run();
          run_record.begin(folder, claimed);
          return;
        }
      cut_tables();
      run_record.add_files(claimed);
    });
  }



  void
  RunFolder::remove_earlier_run()
  {
    std::set<std::string> folders = {""};
    for (const std::string &name : run_record.files())
      folders.insert(name.substr(0, name.rfind('/') + 1));
    // That of the parameters will be overwritten: it may be the input of the
    // run, and is never not there.
    for (const std::string &name : folders)
      remove(name, [](const std::string &file) { return file != parameters; });
  }



  void
  RunFolder::remove(const std::string                              &name,
                    const std::function<bool(const std::string &)> &which) const
  {
    const files::path path = files::path(folder) / name;
    for (const std::string &present : names_in(path))
      {
        const std::string from_folder =
          (files::path(name) / final_name(present)).string();
        std::error_code error;
        if (run_record.files().count(from_folder) > 0 &&
            which(final_name(present)) && is_regular(path / present))
          files::remove(path / present, error);
        AssertThrow(!error,
                    ExcSolveFailed("The file '" + (path / present).string() +
                                   "', of an earlier run, cannot be removed: " +
                                   error.message() + "."));
      }
  }



  void
  RunFolder::cut_tables()
  {
    for (const auto &[name, content] : continued_tables)
      {
        const std::string file_name = folder + "/" + name;
        std::error_code   error;
        files::resize_file(file_name, content.value().size, error);
        AssertThrow(!error,
                    ExcSolveFailed("The table '" + file_name +
                                   "' cannot be changed: " + error.message() +
                                   "."));
      }
    // What was not whole when the run ended.
    for (const std::string sub_folder : {"", "vtu/"})
      for (const std::string &present :
           names_in(files::path(folder) / sub_folder))
        if (final_name(present) != present &&
            run_record.files().count(sub_folder + final_name(present)) > 0 &&
            is_regular(files::path(folder) / sub_folder / present))
          {
            std::error_code error;
            files::remove(files::path(folder) / sub_folder / present, error);
          }
  }



  void
  RunFolder::write(const std::string                         &name,
                   const std::function<void(std::ostream &)> &writer) const
  {
    const std::string whole_name     = folder + "/" + name;
    const std::string temporary_name = whole_name + not_whole_yet;
    const auto        fail           = [&](const std::string &reason) {
      AssertThrow(false,
                  ExcSolveFailed("The file '" + whole_name +
                                 "' cannot be written: " + reason + "."));
    };

    // Never through a link, or into a file that somebody else has put there.
    const int file = open(temporary_name.c_str(),
                          O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC,
                          0666);
    if (file < 0)
      fail(std::strerror(errno));
    close(file);

    std::string reason;
    {
      std::ofstream out(temporary_name, std::ios::binary);
      try
        {
          if (out)
            writer(out);
        }
      catch (const dealii::StandardExceptions::ExcIO &)
        {
          // deal.II's writers look at the stream too.
        }
      out.close();
      if (!out)
        reason = std::strerror(errno);
    }
    if (reason.empty() &&
        std::rename(temporary_name.c_str(), whole_name.c_str()) != 0)
      reason = std::strerror(errno);
    if (!reason.empty())
      {
        std::remove(temporary_name.c_str());
        fail(reason);
      }
  }



  void
  RunFolder::write_collectively(
    const std::string                         &name,
    const bool                                 writes,
    const std::function<void(std::ostream &)> &writer) const
  {
    std::string reason;
    if (writes)
      try
        {
          write(name, writer);
        }
      catch (const ExcSolveFailed &exception)
        {
          reason = plain_message(exception);
        }
    throw_on_all_ranks<ExcSolveFailed>(reason, comm);
  }



  void
  RunFolder::on_first_rank(const std::function<void()> &action) const
  {
    std::string reason;
    if (is_first)
      try
        {
          action();
        }
      catch (const ExcSolveFailed &exception)
        {
          reason = plain_message(exception);
        }
    throw_on_all_ranks<ExcSolveFailed>(reason, comm);
  }
} // namespace lumbricus
