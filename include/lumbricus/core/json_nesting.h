// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_json_nesting_h
#define lumbricus_core_json_nesting_h

#include <cstddef>
#include <string>

namespace lumbricus
{
  /**
   * Where in the text @p json more than @p most objects and arrays are in each
   * other, or its size where they nowhere are. Boost's parser calls itself for
   * each, and has no limit.
   */
  std::size_t
  where_nested_deeper(const std::string &json, const std::size_t most);
} // namespace lumbricus

#endif
