// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/json_nesting.h>

namespace lumbricus
{
  std::size_t
  where_nested_deeper(const std::string &json, const std::size_t most)
  {
    std::size_t depth   = 0;
    bool        in_text = false;
    for (std::size_t i = 0; i < json.size(); ++i)
      {
        const char c = json[i];
        if (in_text && c == '\\')
          ++i;
        else if (c == '"')
          in_text = !in_text;
        else if (!in_text && (c == '{' || c == '['))
          ++depth;
        else if (!in_text && (c == '}' || c == ']') && depth > 0)
          --depth;
        if (depth > most)
          return i;
      }
    return json.size();
  }
} // namespace lumbricus
