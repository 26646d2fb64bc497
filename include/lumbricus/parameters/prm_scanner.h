// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_parameters_prm_scanner_h
#define lumbricus_parameters_prm_scanner_h

#include <string>
#include <vector>

namespace lumbricus
{
  /** One `set` or `subsection` line of a parameter file. */
  struct PrmLine
  {
    /** Counted from one. */
    unsigned int number;
    /** "Section/Subsection/Name" of the entry, or of the section itself. */
    std::string path;
    /** Whether it opens a section; else it sets an entry. */
    bool is_section;
    /** What the entry is set to, without blanks at its ends. */
    std::string value = "";
  };

  /**
   * What a parameter file says: which sections and entries it names, where,
   * and the values. There has to be no first_mistake().
   */
  std::vector<PrmLine>
  scan_prm(const std::string &text);

  /** A line that is none of a parameter file, or more than InputLimits allow,
   * and what is wrong with it. */
  struct PrmMistake
  {
    unsigned int line = 0; ///< from 1; 0 where there is no mistake
    std::string  what;     ///< in words
  };

  /** The first there is; its line is 0 where there is none. */
  PrmMistake
  first_mistake(const std::string &text);

  /** What a name or value has that a line of a parameter file cannot hold, in
   * words; empty if there is nothing. */
  std::string
  unfit_for_a_line(const std::string &text);

  /** "A/B/Name" into {"A", "B", "Name"}. */
  std::vector<std::string>
  split_path(const std::string &path);

  /**
   * The candidate that differs from @p word in the fewest letters, or an empty
   * string where none is near enough to be what was meant.
   */
  std::string
  nearest(const std::string &word, const std::vector<std::string> &candidates);
} // namespace lumbricus

#endif
