// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/json_value.h>
#include <lumbricus/core/user_text.h>

#include <boost/property_tree/json_parser.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace lumbricus
{
  namespace
  {
    std::string
    quoted(const std::string &text)
    {
      const std::string escaped = boost::property_tree::json_parser::
        create_escapes(printable(text, text.size()));
      // Boost puts a '\' before every '/' too, which nobody needs.
      std::string plain;
      for (const char c : escaped)
        {
          if (c == '/')
            plain.pop_back();
          plain += c;
        }
      return '"' + plain + '"';
    }
  } // namespace



  JsonValue::JsonValue(const std::string &text)
    : scalar(quoted(text))
  {}



  JsonValue::JsonValue(const char *text)
    : JsonValue(std::string(text))
  {}



  JsonValue::JsonValue(const std::vector<std::string> &texts)
    : kind(Kind::array)
  {
    for (const std::string &text : texts)
      append(text);
  }



  JsonValue
  JsonValue::object()
  {
    JsonValue value;
    value.kind = Kind::object;
    return value;
  }



  JsonValue
  JsonValue::array()
  {
    JsonValue value;
    value.kind = Kind::array;
    return value;
  }



  std::string
  JsonValue::digits_of(const double value)
  {
    if (!std::isfinite(value))
      return "null";
    // Enough for "-1.2345678901234567e-308".
    std::array<char, 32> digits;
    const auto           end =
      std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    return std::string(digits.data(), end);
  }



  bool
  JsonValue::is_one_line() const
  {
    return std::all_of(members.begin(), members.end(), [](const auto &member) {
      const JsonValue &value = member.second;
      return value.kind == Kind::scalar ||
             (value.kind == Kind::array &&
              std::all_of(value.members.begin(),
                          value.members.end(),
                          [](const auto &element) {
                            return element.second.kind == Kind::scalar;
                          }));
    });
  }



  void
  JsonValue::write(std::ostream &out) const
  {
    write(out, 0, false);
  }



  void
  JsonValue::write_line(std::ostream &out) const
  {
    write(out, 0, true);
  }



  void
  JsonValue::write(std::ostream      &out,
                   const unsigned int depth,
                   const bool         always_one_line) const
  {
    if (kind == Kind::scalar)
      {
        out << scalar;
        return;
      }
    const bool        one_line = always_one_line || is_one_line();
    const std::string gap =
      one_line ? "" : "\n" + std::string(2 * (depth + 1), ' ');
    out << (kind == Kind::object ? '{' : '[');
    for (std::size_t i = 0; i < members.size(); ++i)
      {
        out << (i == 0 ? "" : one_line ? ", " : ",") << gap;
        if (kind == Kind::object)
          out << quoted(members[i].first) << ": ";
        members[i].second.write(out, depth + 1, always_one_line);
      }
    if (!one_line)
      out << "\n" << std::string(2 * depth, ' ');
    out << (kind == Kind::object ? '}' : ']');
  }
} // namespace lumbricus
