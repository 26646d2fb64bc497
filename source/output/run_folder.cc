// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/output/run_folder.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace lumbricus
{
  RunFolder::RunFolder(const std::string &path, const MPI_Comm comm)
    : folder(path)
    , comm(comm)
  {
    std::string reason;
    if (dealii::Utilities::MPI::this_mpi_process(comm) == 0)
      {
        std::error_code error;
        if (!folder.empty())
          std::filesystem::create_directories(folder + "/vtu", error);
        if (folder.empty())
          reason = "it has no name.";
        else if (error)
          reason = error.message() + ".";
        else
          try
            {
              write("vtu/.writable", [](std::ostream &) {});
              std::filesystem::remove(folder + "/vtu/.writable", error);
            }
          catch (const ExcSolveFailed &exception)
            {
              reason = plain_message(exception);
            }
        if (!reason.empty())
          reason = "The output folder '" + folder +
                   "' cannot be written: " + reason +
                   " Choose another with 'Output/Folder' or --output.";
      }
    throw_on_all_ranks<ExcInput>(reason, comm);
  }



  const std::string &
  RunFolder::path() const
  {
    return folder;
  }



  void
  RunFolder::continue_tables(const std::map<std::string, std::uintmax_t> &sizes)
  {
    std::string reason;
    for (const auto &[name, size] : sizes)
      {
        continued_tables.insert(name);
        if (dealii::Utilities::MPI::this_mpi_process(comm) != 0)
          continue;
        const std::string file_name = folder + "/" + name;
        std::error_code   error;
        const auto present = std::filesystem::file_size(file_name, error);
        if (error || present < size)
          reason = "The table '" + file_name +
                   "' is shorter than it was at the checkpoint" +
                   (error ? " (" + error.message() + ")" : "") +
                   ". Bring it back, or start the run from its parameter file.";
        else
          std::filesystem::resize_file(file_name, size, error);
        if (error && reason.empty())
          reason = "The table '" + file_name +
                   "' cannot be changed: " + error.message() +
                   ". See that it may be written.";
      }
    throw_on_all_ranks<ExcInput>(reason, comm);
  }



  bool
  RunFolder::continues(const std::string &name) const
  {
    return continued_tables.count(name) > 0;
  }



  void
  RunFolder::write(const std::string                         &name,
                   const std::function<void(std::ostream &)> &writer) const
  {
    const std::string final_name     = folder + "/" + name;
    const std::string temporary_name = final_name + ".incomplete";
    std::string       reason;
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
    if (!reason.empty())
      {
        std::remove(temporary_name.c_str());
        AssertThrow(false,
                    ExcSolveFailed("The file '" + final_name +
                                   "' cannot be written: " + reason + "."));
      }
    AssertThrow(std::rename(temporary_name.c_str(), final_name.c_str()) == 0,
                ExcSolveFailed("The file '" + final_name +
                               "' cannot be written: " + std::strerror(errno) +
                               "."));
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
} // namespace lumbricus
