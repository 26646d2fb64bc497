// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_checkpoint_run_progress_h
#define lumbricus_checkpoint_run_progress_h

#include <lumbricus/core/fingerprint.h>
#include <lumbricus/core/state.h>

#include <iosfwd>
#include <map>
#include <set>
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
    /** The names of State::histories. */
    std::set<std::string> histories;
    /** State::globals. */
    Globals globals;
    /** The times of State::past. */
    std::vector<double> past;
    /** The Continuation, as users name it. */
    std::string control;
    /** Continuation::numbers(). */
    std::map<std::string, double> numbers;
    double elapsed_seconds = 0.; ///< of all runs up to here
    /** What there is of the tables. */
    std::map<std::string, Fingerprint> tables;
    /** The OutputFormat of the pictures, as users name it. */
    std::string format;
    /** The pictures so far, see OutputFormat::Pictures. */
    std::vector<std::pair<double, std::string>> pictures;
    /** Whether the last of them is that of this state. */
    bool picture_is_current = false;

    /** Write it as lines of an item and its values. */
    void
    write(std::ostream &out) const;

    /** Read what write() wrote. Throws ExcUnknownItem, and ExcDamaged where
     * something is missing or cannot be. */
    static RunProgress
    read(const std::string &text);
  };
} // namespace lumbricus

#endif
