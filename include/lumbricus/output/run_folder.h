// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_output_run_folder_h
#define lumbricus_output_run_folder_h

#include <deal.II/base/mpi.h>

#include <cstdint>
#include <fstream>
#include <functional>
#include <map>
#include <ostream>
#include <set>
#include <string>

namespace lumbricus
{
  /** Where the results of a run go. */
  class RunFolder
  {
  public:
    /**
     * Make the folder, on rank 0. Throws ExcInput on all ranks where files
     * cannot be written there. Collective.
     */
    RunFolder(const std::string &path, const MPI_Comm comm);

    /** As the user wrote it. */
    const std::string &
    path() const;

    /** The tables go on, each after so many bytes; what follows is cut off.
     * Throws ExcInput where one is shorter. Collective. */
    void
    continue_tables(const std::map<std::string, std::uintmax_t> &sizes);

    /** Whether the table @p name goes on. */
    bool
    continues(const std::string &name) const;

    /**
     * Write the file @p name in the folder: whole or not at all, because it
     * gets its name when it is complete. Only on the rank that calls.
     * Throws ExcSolveFailed (the disk is full).
     */
    void
    write(const std::string                         &name,
          const std::function<void(std::ostream &)> &writer) const;

    /**
     * Write on the ranks where @p writes, and throw on all where any failed.
     * Collective.
     */
    void
    write_collectively(const std::string                         &name,
                       const bool                                 writes,
                       const std::function<void(std::ostream &)> &writer) const;

  private:
    const std::string     folder;
    const MPI_Comm        comm;
    std::set<std::string> continued_tables;
  };
} // namespace lumbricus

#endif
