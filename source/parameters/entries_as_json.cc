// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/number_in_text.h>
#include <lumbricus/parameters/entries_as_json.h>
#include <lumbricus/parameters/patterns.h>

#include <deal.II/base/patterns.h>

#include <string>

namespace lumbricus
{
  namespace
  {
    // A number or true and false where the pattern asks for one, else the text
    // of the parameter file.
    JsonValue
    typed(const std::string &value, const std::string &pattern)
    {
      if (pattern == dealii::Patterns::Bool().description())
        return JsonValue(value == "true");
      long long whole;
      if (pattern.compare(0, 8, "[Integer") == 0 && read_number(value, whole))
        return JsonValue(whole);
      double number;
      if ((pattern.compare(0, 7, "[Double") == 0 ||
           pattern == PositiveNumber().description()) &&
          read_number(value, number))
        return JsonValue(number);
      return JsonValue(value);
    }
  } // namespace



  JsonValue
  as_json(const std::vector<ParameterEntry> &entries)
  {
    JsonValue all = JsonValue::array();
    for (const ParameterEntry &entry : entries)
      all.append(JsonValue::object()
                   .add("path", entry.path)
                   .add("value", typed(entry.value, entry.pattern))
                   .add("default", typed(entry.default_value, entry.pattern))
                   .add("unit", entry.unit)
                   .add("meaning", entry.meaning));
    return all;
  }
} // namespace lumbricus
