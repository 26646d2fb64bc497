// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_checkpoint_run_progress_h
#define lumbricus_checkpoint_run_progress_h

#include <cstdint>
#include <iosfwd>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace lumbricus
{
  /** Where a run is, besides its State: what goes on from here needs it. */
  struct RunProgress
  {
    double       time = 0.; ///< State::time
    unsigned int step = 0;  ///< the load step it ended, from 1
    /** The size of the load step wanted next. */
    double step_size       = 0.;
    double elapsed_seconds = 0.; ///< of all runs up to here
    /** How long the tables are [bytes]. */
    std::map<std::string, std::uintmax_t> table_sizes;
    /** The VTU files so far, by time. */
    std::vector<std::pair<double, std::string>> vtu_files;
    /** Whether the last of them is that of this state. */
    bool vtu_is_current = false;

    /** Write it as lines of an item and its values. */
    void
    write(std::ostream &out) const;

    /** Read what write() wrote. @p unknown is set to the first item that no
     * RunProgress has. */
    static RunProgress
    read(std::istream &in, std::string &unknown);
  };
} // namespace lumbricus

#endif
