// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/user_text.h>
#include <lumbricus/parameters/pattern_words.h>

#include <deal.II/base/utilities.h>

#include <limits>
#include <regex>
#include <string>
#include <vector>

namespace lumbricus
{
  namespace
  {
    // " from 0 to 0.5"; without the bounds that are those of the type.
    std::string
    range(const std::string &from, const std::string &to)
    {
      const auto is_bound = [](const std::string &number) {
        return number.find("MAX_DOUBLE") == std::string::npos &&
               number != std::to_string(std::numeric_limits<int>::min()) &&
               number != std::to_string(std::numeric_limits<int>::max());
      };
      if (is_bound(from) && is_bound(to))
        return " from " + from + " to " + to;
      return is_bound(from) ? ", at least " + from :
             is_bound(to)   ? ", at most " + to :
                              "";
    }



    // "3 entries", "1 to 4 entries"; without the bounds there are always.
    std::string
    entries(const std::string &least, const std::string &most)
    {
      if (least == most)
        return least + " entries";
      const bool any =
        most == std::to_string(std::numeric_limits<unsigned int>::max());
      return (any ? (least != "0" ? "at least " + least + " " : "") :
                    (least != "0" ? least + " to " : "at most ") + most +
                      " ") +
             "entries";
    }



    // "'a', 'b', 'c'" of "a|b|c".
    std::string
    alternatives(const std::string &names)
    {
      std::vector<std::string> all;
      for (const std::string &name :
           dealii::Utilities::split_string_list(names, '|'))
        if (!name.empty())
          all.push_back(name);
      return quoted_list(all);
    }
  } // namespace



  std::string
  pattern_in_words(const std::string &description)
  {
    static const std::regex real(
      "\\[Double (\\S+)\\.\\.\\.(\\S+) \\(inclusive\\)\\]");
    static const std::regex integer(
      "\\[Integer range (\\S+)\\.\\.\\.(\\S+) \\(inclusive\\)\\]");
    static const std::regex selection("\\[Selection ([\\s\\S]*?) *\\]");
    static const std::regex selections(
      "\\[MultipleSelection ([\\s\\S]*?) *\\]");
    static const std::regex list(
      "\\[List of <([\\s\\S]*)> of length ([0-9]+)\\.\\.\\.([0-9]+) "
      "\\(inclusive\\)[\\s\\S]*\\]");

    std::smatch parts;
    if (description == "[Double]")
      return "a number";
    if (description == "[Integer]")
      return "a whole number";
    if (description == "[Bool]")
      return "true or false";
    if (description == "[A number > 0]")
      return "a number > 0";
    if (description == "[Name]")
      return "a name, without '/'";
    if (std::regex_match(description, parts, real))
      return "a number" + range(parts[1], parts[2]);
    if (std::regex_match(description, parts, integer))
      return "a whole number" + range(parts[1], parts[2]);
    if (std::regex_match(description, parts, selection))
      return "one of " + alternatives(parts[1]);
    if (std::regex_match(description, parts, selections))
      return "a list out of " + alternatives(parts[1]);
    if (std::regex_match(description, parts, list))
      return "a list of " + entries(parts[2], parts[3]) + ", each " +
             pattern_in_words(parts[1]);
    if (description.compare(0, 5, "[Map ") == 0)
      return "a list of entries 'name: value'";
    return description;
  }
} // namespace lumbricus
