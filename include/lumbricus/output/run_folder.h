// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_output_run_folder_h
#define lumbricus_output_run_folder_h

#include <lumbricus/output/run_lock.h>
#include <lumbricus/output/run_record.h>

#include <deal.II/base/mpi.h>

#include <cstdint>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <ostream>
#include <set>
#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * Where the results of a run go. The run owns the folder (RunLock); in it,
   * what the RunRecord lists. Until begin() nothing that was there before is
   * changed; then what an earlier run has left is removed, or, where a run goes
   * on, cut back to its checkpoint.
   */
  class RunFolder
  {
  public:
    /** What is to be done in the folder. */
    enum class Use
    {
      write,   ///< make it where it does not exist, and lock it
      restart, ///< lock it
      look     ///< only read
    };

    /**
     * Throws ExcInput where files cannot be written there, another run does
     * write there, or the record of what a run has written is damaged.
     * Collective.
     */
    RunFolder(const std::string &path, const Use use, const MPI_Comm comm);

    /** As the user wrote it. */
    const std::string &
    path() const;

    /**
     * The file @p name will be written. Throws ExcInput where there is one that
     * no run has written. Before begin(). Collective.
     */
    void
    claim(const std::string &name);

    /**
     * In the folder @p name, which is made where it does not exist, the files
     * that @p is_ours says yes to will be written. Throws ExcInput where there
     * is one that no run has written. Before begin(). Collective.
     */
    void
    claim_folder(const std::string                              &name,
                 const std::function<bool(const std::string &)> &is_ours);

    /** The tables go on, each after so many bytes. Throws ExcInput where the
     * beginning of one is not as it was. Before begin(). Collective. */
    void
    continue_tables(const std::map<std::string, Fingerprint> &sizes);

    /** Whether the table @p name goes on. */
    bool
    continues(const std::string &name) const;

    /** What there is of the table @p name, which goes on; on rank 0. */
    GrowingFingerprint
    content(const std::string &name) const;

    /**
     * Begin to write, now that the input has turned out to be right. Where no
     * table goes on, and @p fresh, all files of an earlier run are removed.
     * Throws ExcSolveFailed. Collective.
     */
    void
    begin(const bool fresh);

    /** What has been written, on rank 0; empty on others. */
    RunRecord &
    record() const;

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

    /** Run @p action on rank 0; an ExcSolveFailed of it is thrown on all.
     * Collective. */
    void
    on_first_rank(const std::function<void()> &action) const;

    /** Remove the files that @p which says yes to, of those in the folder
     * @p name that the run has written. Only on rank 0. */
    void
    remove(const std::string                              &name,
           const std::function<bool(const std::string &)> &which) const;

  private:
    /** Whether there is a file @p name that no run has written. */
    bool
    has_foreign(const std::string &name) const;

    /** The message on such a file. */
    std::string
    foreign(const std::string &name) const;

    void
    remove_earlier_run();

    void
    cut_tables();

    const std::string        folder;
    const MPI_Comm           comm;
    const bool               is_first; ///< rank 0
    std::unique_ptr<RunLock> lock;
    mutable RunRecord        run_record;

    std::vector<std::string>                  claimed;
    std::map<std::string, GrowingFingerprint> continued_tables;
  };
} // namespace lumbricus

#endif
