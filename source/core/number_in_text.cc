// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/number_in_text.h>

#include <charconv>
#include <cmath>
#include <cstdlib>

namespace lumbricus
{
  bool
  read_number(const std::string &word, double &value)
  {
    // std::strtod() also takes blanks, "nan", "inf" and hexadecimal numbers.
    if (word.empty() ||
        word.find_first_not_of("0123456789+-.eE") != std::string::npos)
      return false;
    char *end = nullptr;
    value     = std::strtod(word.c_str(), &end);
    return end == word.c_str() + word.size() && std::isfinite(value);
  }



  bool
  read_number(const std::string &word, long long &value)
  {
    const char *end    = word.data() + word.size();
    const auto  result = std::from_chars(word.data(), end, value);
    return !word.empty() && result.ec == std::errc() && result.ptr == end;
  }
} // namespace lumbricus
