// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_output_run_lock_h
#define lumbricus_output_run_lock_h

#include <deal.II/base/mpi.h>

#include <string>

namespace lumbricus
{
  /**
   * The right of one run to write to a folder, for as long as this lives: the
   * file lumbricus.lock there names the process that has it.
   *
   * While any rank lives the kernel has a lock on that file, which goes with
   * the process, however it ends. So where the file system is of this machine,
   * a file that is left by a run that was killed is seen to be stale. On a
   * network a kernel's lock may not reach other machines: there the process
   * that the file names is looked for, by its number and its start, and one
   * on another machine counts as alive.
   */
  class RunLock
  {
  public:
    /** Take it for @p folder, which exists. Throws ExcInput where another run
     * has it, or where files cannot be written there. Collective. */
    RunLock(const std::string &folder, const MPI_Comm comm);

    /** Give it back. */
    ~RunLock();

    RunLock(const RunLock &) = delete;
    RunLock &
    operator=(const RunLock &) = delete;

    /** The name of the file in the folder. */
    static const std::string file_name;

  private:
    /** On rank 0. @return why it cannot be taken, or "". */
    std::string
    take();

    /** The message that somebody has it, whom its @p content names. */
    std::string
    refusal(const std::string &content, const bool may_be_stale) const;

    const std::string folder;
    const std::string path;
    const bool        is_first; ///< rank 0, which owns the file
    int               file  = -1;
    bool              taken = false;
  };



  /** A process that holds a lock: what its file says. */
  struct LockHolder
  {
    std::string host;    ///< the name of the machine
    std::string boot;    ///< the kernel's id of the time since it was started
    std::string process; ///< its number
    std::string start;   ///< when it was started [ticks since the boot]
    std::string since;   ///< when it took the lock, to be read by people

    /** The holder that this process is. */
    static LockHolder
    this_process();

    /** Read what text() wrote; all is empty where it is something else. */
    static LockHolder
    read(const std::string &content);

    /** The content of the file. */
    std::string
    text() const;

    /** Whether it is known to have ended: it was on this machine, which has no
     * process of that number and start now. */
    bool
    has_ended() const;
  };
} // namespace lumbricus

#endif
