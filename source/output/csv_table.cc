// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/output/csv_table.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace lumbricus
{
  namespace
  {
    // Whether the first @p size bytes of a file begin with @p line.
    bool
    begins_with(const std::string   &file_name,
                const std::string   &line,
                const std::uintmax_t size)
    {
      std::ifstream in(file_name, std::ios::binary);
      std::string   present(line.size(), '\0');
      in.read(present.data(), present.size());
      return size >= line.size() && in && present == line;
    }
  } // namespace



  CsvTable::CsvTable(RunFolder                      &folder,
                     const std::string              &name,
                     const std::vector<std::string> &columns,
                     const MPI_Comm                  comm)
    : folder(folder)
    , name(name)
    , file_name(folder.path() + "/" + name)
    , comm(comm)
    , writes(dealii::Utilities::MPI::this_mpi_process(comm) == 0)
    , started(folder.continues(name))
    , pending(columns)
  {
    folder.claim(name);
    if (started)
      {
        content = folder.content(name);
        throw_on_all_ranks<ExcInput>(
          !writes || begins_with(file_name,
                                 pending.first_line(),
                                 content.value().size) ?
            "" :
            "The table '" + file_name +
              "' has other columns than this version writes. Go on with the "
              "version that wrote it, or start the run from its parameter "
              "file.",
          comm);
      }
  }



  TableRows &
  CsvTable::rows()
  {
    return pending;
  }



  std::pair<std::string, Fingerprint>
  CsvTable::name_and_content() const
  {
    return {name, content.value()};
  }



  void
  CsvTable::flush()
  {
    const std::string rows =
      (started ? "" : pending.first_line()) + pending.take();
    if (!started)
      folder.write_collectively(name, writes, [&](std::ostream &out) {
        out << rows;
      });
    else
      throw_on_all_ranks<ExcSolveFailed>(writes ? append(rows) : "", comm);
    started = true;
    content.add(rows);
  }



  std::string
  CsvTable::append(const std::string &text) const
  {
    const std::string begin =
      "The file '" + file_name + "' cannot be written: ";
    std::error_code error;
    const auto      present = std::filesystem::file_size(file_name, error);
    if (error)
      return begin + error.message() + ".";
    if (present != content.value().size)
      return begin + "somebody else has changed it.";
    std::ofstream out(file_name, std::ios::app);
    out << text << std::flush;
    return out ? "" : begin + std::strerror(errno) + ".";
  }
} // namespace lumbricus
