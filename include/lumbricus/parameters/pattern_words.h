// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_parameters_pattern_words_h
#define lumbricus_parameters_pattern_words_h

#include <string>

namespace lumbricus
{
  /**
   * What a pattern of dealii::Patterns allows, in words, from its description:
   * "[Double 0...0.5 (inclusive)]" is "a number from 0 to 0.5". A description
   * that is not known is returned as it is.
   */
  std::string
  pattern_in_words(const std::string &description);
} // namespace lumbricus

#endif
