// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_output_csv_table_h
#define lumbricus_output_csv_table_h

#include <lumbricus/output/run_folder.h>

#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace lumbricus
{
  /**
   * A table on disk in the comma-separated form of RFC 4180, grown by whole
   * rows. Only rank 0 holds and writes it.
   */
  class CsvTable
  {
  public:
    /** The file @p name, which the first flush() starts with a line of column
     * names, unless the folder says that it goes on. Before
     * RunFolder::begin(). Throws ExcInput, see RunFolder::claim().
     * Collective. */
    CsvTable(RunFolder                      &folder,
             const std::string              &name,
             const std::vector<std::string> &columns,
             const MPI_Comm                  comm);

    /** Add an entry to the row being made; numbers with 15 digits. */
    template <typename T>
    CsvTable &
    operator<<(const T &entry);

    /** End the row. */
    void
    end_row();

    /** Its name in the folder and what there is of it, on rank 0. */
    std::pair<std::string, Fingerprint>
    name_and_content() const;

    /**
     * Bring the rows made since the last call to disk, all at once. Throws
     * ExcSolveFailed on all ranks where that is not possible, or where the
     * file is not as long as the last call has left it. Collective.
     */
    void
    flush();

  private:
    /** Add to the file. @return why that is not possible, or "". */
    std::string
    append(const std::string &rows) const;

    const RunFolder   &folder;
    const std::string  name;
    const std::string  file_name;
    const std::size_t  n_columns;
    const MPI_Comm     comm;
    const bool         writes;
    bool               started   = false;
    std::size_t        n_entries = 0;
    GrowingFingerprint content; ///< of the file
    std::ostringstream pending;
  };



  /** @p text as an entry of a table: in quotes where it needs them. */
  std::string
  csv_text(const std::string &text);



  template <typename T>
  CsvTable &
  CsvTable::operator<<(const T &entry)
  {
    pending << (n_entries == 0 ? "" : ",") << entry;
    ++n_entries;
    return *this;
  }
} // namespace lumbricus

#endif
