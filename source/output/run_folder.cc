// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/output/run_folder.h>

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
          reason = "it has no name";
        else if (error)
          reason = error.message();
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
                   ". Choose another with 'Output/Folder' or --output.";
      }
    throw_on_all_ranks<ExcInput>(reason, comm);
  }



  const std::string &
  RunFolder::path() const
  {
    return folder;
  }



  void
  RunFolder::write(const std::string                         &name,
                   const std::function<void(std::ostream &)> &writer) const
  {
    const std::string final_name     = folder + "/" + name;
    const std::string temporary_name = final_name + ".incomplete";
    {
      std::ofstream out(temporary_name, std::ios::binary);
      if (out)
        writer(out);
      out.close();
      AssertThrow(out,
                  ExcSolveFailed(
                    "The file '" + temporary_name +
                    "' cannot be written: " + std::strerror(errno)));
    }
    AssertThrow(std::rename(temporary_name.c_str(), final_name.c_str()) == 0,
                ExcSolveFailed("The file '" + final_name +
                               "' cannot be written: " + std::strerror(errno)));
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
