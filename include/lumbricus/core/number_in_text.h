// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_number_in_text_h
#define lumbricus_core_number_in_text_h

#include <string>

namespace lumbricus
{
  /**
   * Whether all of @p word is one finite decimal number, as "-1.5e3", and
   * which. Not "nan", "inf", "0x10", "1e", "1.5mm", "1e999".
   */
  bool
  read_number(const std::string &word, double &value);

  /** Whether all of @p word is one integer, as "-12", and which. Not "1.0". */
  bool
  read_number(const std::string &word, long long &value);
} // namespace lumbricus

#endif
