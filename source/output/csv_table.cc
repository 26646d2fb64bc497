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
  CsvTable::CsvTable(const RunFolder                &folder,
                     const std::string              &name,
                     const std::vector<std::string> &columns,
                     const MPI_Comm                  comm)
    : name(name)
    , file_name(folder.path() + "/" + name)
    , n_columns(columns.size())
    , comm(comm)
    , writes(dealii::Utilities::MPI::this_mpi_process(comm) == 0)
  {
    pending.precision(15);
    if (folder.continues(name))
      return;
    folder.write_collectively(name, writes, [&](std::ostream &out) {
      for (const std::string &column : columns)
        out << (&column == &columns.front() ? "" : ",") << column;
      out << '\n';
    });
  }



  std::pair<std::string, std::uintmax_t>
  CsvTable::name_and_size() const
  {
    // Where the file is gone the next row will say so, on all ranks.
    std::error_code error;
    const auto size = writes ? std::filesystem::file_size(file_name, error) : 0;
    return {name, error ? 0 : size};
  }



  void
  CsvTable::end_row()
  {
    AssertDimension(n_entries, n_columns);
    pending << '\n';
    n_entries = 0;
  }



  void
  CsvTable::flush()
  {
    std::string reason;
    if (writes)
      {
        std::ofstream out(file_name, std::ios::app);
        out << pending.str() << std::flush;
        if (!out)
          reason = "The file '" + file_name +
                   "' cannot be written: " + std::strerror(errno) + ".";
      }
    pending.str("");
    throw_on_all_ranks<ExcSolveFailed>(reason, comm);
  }
} // namespace lumbricus
