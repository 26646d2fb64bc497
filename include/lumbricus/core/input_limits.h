// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_input_limits_h
#define lumbricus_core_input_limits_h

#include <cstddef>

namespace lumbricus
{
  /**
   * How much input is taken. People stay far below all of these; a file that
   * does not is damaged, or none of this program, and is refused before it
   * takes all the time or memory there is.
   */
  namespace InputLimits
  {
    /** Bytes of all parameter files of a run. */
    constexpr std::size_t bytes = 16 << 20;
    /** Parameter files of a run, each counted as often as it is included. */
    constexpr unsigned int files = 1000;
    /** Files in which a file is included by another. */
    constexpr unsigned int includes = 64;
    /** Sections in a section. */
    constexpr unsigned int sections = 64;
    /** Characters of a line with those that continue it, and so of a value. */
    constexpr std::size_t line = 100000;
    /** Characters of the name of a section or parameter. */
    constexpr std::size_t name = 100;
    /** Names in a list of them. */
    constexpr unsigned int names = 1000;
    /** Characters of a formula, which muParser limits too. */
    constexpr std::size_t formula = 20000;
    /** Characters of a message. */
    constexpr std::size_t message = 900;
  } // namespace InputLimits
} // namespace lumbricus

#endif
