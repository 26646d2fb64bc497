// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_output_csv_table_h
#define lumbricus_output_csv_table_h

#include <lumbricus/output/run_folder.h>
#include <lumbricus/output/table_rows.h>

#include <string>
#include <utility>
#include <vector>

namespace lumbricus
{
  /**
   * A table on disk, grown by whole rows. Only rank 0 writes it.
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

    /** Where the rows are made. */
    TableRows &
    rows();

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
    append(const std::string &text) const;

    const RunFolder   &folder;
    const std::string  name;
    const std::string  file_name;
    const MPI_Comm     comm;
    const bool         writes;
    bool               started = false;
    TableRows          pending;
    GrowingFingerprint content; ///< of the file
  };
} // namespace lumbricus

#endif
