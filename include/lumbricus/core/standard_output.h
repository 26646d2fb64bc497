// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_standard_output_h
#define lumbricus_core_standard_output_h

#include <string>

namespace lumbricus
{
  /**
   * Where a run writes what it says. A reader that takes nothing (a pager, a
   * terminal after Ctrl-S, mpirun after Ctrl-C, which reads no more) holds the
   * run up, but not its end: once the run is interrupted it waits for a second
   * at most.
   */
  class StandardOutput
  {
  public:
    StandardOutput();
    ~StandardOutput();

    StandardOutput(const StandardOutput &) = delete;
    StandardOutput &
    operator=(const StandardOutput &) = delete;

    /** Write @p text. @return 0, or the errno with which that failed; ETIMEDOUT
     * where an interrupted run has not waited any longer. */
    int
    write(const std::string &text);

  private:
    /** Wait until more can be written, but not for long. @return whether it can
     * be tried. */
    bool
    wait();

    int own    = -1; ///< that file, opened so that writing does not block
    int waited = 0;  ///< milliseconds since the run was interrupted
  };
} // namespace lumbricus

#endif
