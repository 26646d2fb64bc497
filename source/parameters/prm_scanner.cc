// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/input_limits.h>
#include <lumbricus/core/user_text.h>
#include <lumbricus/parameters/prm_scanner.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace lumbricus
{
  namespace
  {
    // The rest of @p line behind @p keyword (in small or capital letters) and
    // at least one blank; found = false where the line does not start so.
    std::string
    behind(const std::string &line, const std::string &keyword, bool &found)
    {
      std::string upper = keyword;
      std::transform(upper.begin(), upper.end(), upper.begin(), ::toupper);
      const std::size_t n = keyword.size();

      found =
        line.size() > n && std::isspace(line[n]) &&
        (line.compare(0, n, keyword) == 0 || line.compare(0, n, upper) == 0);
      return found ? dealii::Utilities::trim(line.substr(n)) : "";
    }



    // A line, with those that a '\' at its end joins to it, without its
    // comment.
    struct WholeLine
    {
      unsigned int number; // of the first
      std::string  text;
    };



    std::vector<WholeLine>
    whole_lines(const std::string &text)
    {
      std::vector<WholeLine> lines;
      std::istringstream     in(text);
      std::string            raw;
      bool                   goes_on = false;
      for (unsigned int number = 1; std::getline(in, raw); ++number)
        {
          std::string part = dealii::Utilities::trim(raw);
          if (!goes_on)
            lines.push_back({number, ""});
          goes_on = !part.empty() && part.back() == '\\';
          if (goes_on)
            part.pop_back();
          lines.back().text += part;
        }
      for (WholeLine &line : lines)
        {
          line.text =
            dealii::Utilities::trim(line.text.substr(0, line.text.find('#')));
          std::replace(line.text.begin(), line.text.end(), '\t', ' ');
        }
      return lines;
    }



    bool
    is_end(const std::string &line)
    {
      return line == "end" || line == "END";
    }



    // "Name" of "Name = value".
    std::string
    name_in(const std::string &entry)
    {
      return dealii::Utilities::trim(entry.substr(0, entry.find('=')));
    }



    // "value" of "Name = value".
    std::string
    value_in(const std::string &entry)
    {
      return dealii::Utilities::trim(entry.substr(entry.find('=') + 1));
    }



    // As much of a line as a message takes.
    std::string
    beginning(const std::string &line)
    {
      return shortened(line, 60);
    }



    // What InputLimits or the encoding have against a line; empty if nothing.
    std::string
    beyond_limits(const std::string &line,
                  const std::string &name,
                  const std::size_t  depth)
    {
      if (!is_utf8(line))
        return "the line is not in UTF-8. Save the file in this encoding.";
      const std::string quoted = "'" + beginning(line) + "'";
      if (line.size() > InputLimits::line)
        return quoted + " is longer than the " +
               std::to_string(InputLimits::line) +
               " characters that a line may have. Shorten it.";
      if (name.size() > InputLimits::name)
        return quoted + " has a name of more than " +
               std::to_string(InputLimits::name) + " characters. Shorten it.";
      if (depth > InputLimits::sections)
        return quoted + " is in more than " +
               std::to_string(InputLimits::sections) +
               " sections. End those that are complete.";
      return "";
    }



    std::string
    join(const std::vector<std::string> &sections, const std::string &name)
    {
      std::string path;
      for (const std::string &section : sections)
        path += section + "/";
      return path + name;
    }



    // Levenshtein's distance, with case counted as equal.
    unsigned int
    edit_distance(const std::string &a, const std::string &b)
    {
      std::vector<unsigned int> row(b.size() + 1);
      for (unsigned int j = 0; j <= b.size(); ++j)
        row[j] = j;
      for (unsigned int i = 1; i <= a.size(); ++i)
        {
          unsigned int diagonal = row[0];
          row[0]                = i;
          for (unsigned int j = 1; j <= b.size(); ++j)
            {
              const unsigned int substitution =
                diagonal +
                (std::tolower(a[i - 1]) == std::tolower(b[j - 1]) ? 0 : 1);
              diagonal = row[j];
              row[j]   = std::min({substitution, row[j] + 1, row[j - 1] + 1});
            }
        }
      return row[b.size()];
    }
  } // namespace



  std::vector<PrmLine>
  scan_prm(const std::string &text)
  {
    std::vector<PrmLine>     lines;
    std::vector<std::string> sections;
    for (const WholeLine &whole : whole_lines(text))
      {
        bool              is_section, is_entry;
        const std::string section =
          behind(whole.text, "subsection", is_section);
        const std::string entry = behind(whole.text, "set", is_entry);

        if (is_section)
          {
            sections.push_back(section);
            lines.push_back({whole.number, join(sections, ""), true});
            lines.back().path.pop_back();
          }
        else if (is_end(whole.text))
          {
            if (!sections.empty())
              sections.pop_back();
          }
        else if (is_entry)
          lines.push_back(
            {whole.number,
             join(sections, name_in(entry)),
             false,
             value_in(entry)});
      }
    return lines;
  }



  PrmMistake
  first_mistake(const std::string &text)
  {
    std::vector<WholeLine> open;
    for (const WholeLine &whole : whole_lines(text))
      {
        bool              is_section, is_entry;
        const std::string section =
          behind(whole.text, "subsection", is_section);
        const std::string entry = behind(whole.text, "set", is_entry);
        const std::string name  = is_section ? section : name_in(entry);
        const std::string line  = "'" + beginning(whole.text) + "'";

        const std::string beyond =
          beyond_limits(whole.text,
                        is_section || is_entry ? name : "",
                        open.size());
        if (!beyond.empty())
          return {whole.number, beyond};
        if ((is_section || is_entry) && name.find('/') != std::string::npos)
          return {whole.number,
                  line + " has a '/' in its name. Sections are nested here: "
                         "each part before a '/' is a 'subsection'."};
        if (is_section)
          open.push_back(whole);
        else if (is_entry)
          {
            if (entry.find('=') == std::string::npos)
              return {whole.number, line + " has no '='."};
            if (name.empty())
              return {whole.number, line + " has no name before the '='."};
          }
        else if (is_end(whole.text))
          {
            if (open.empty())
              return {whole.number, "'end' without a 'subsection' to end."};
            open.pop_back();
          }
        else if (!whole.text.empty())
          return {whole.number, line + " is none of the lines there are."};
      }
    if (!open.empty())
      return {open.back().number,
              "'" + beginning(open.back().text) + "' has no 'end'."};
    return {};
  }



  std::string
  unfit_for_a_line(const std::string &text)
  {
    if (text.find('#') != std::string::npos)
      return "a '#', which starts a comment";
    if (text.find_first_of("\n\r") != std::string::npos)
      return "a line break";
    std::string without_tabs = text;
    std::replace(without_tabs.begin(), without_tabs.end(), '\t', ' ');
    if (has_control_character(without_tabs))
      return "a control character, which has no place";
    if (!text.empty() && text.back() == '\\')
      return "a '\\' at its end, with which a line goes on";
    return "";
  }



  std::vector<std::string>
  split_path(const std::string &path)
  {
    return dealii::Utilities::split_string_list(path, '/');
  }



  std::string
  nearest(const std::string &word, const std::vector<std::string> &candidates)
  {
    // No name is so long, and the effort is the product of the lengths.
    if (word.size() > InputLimits::name)
      return "";
    std::string  best;
    unsigned int least = 1 + word.size() / 3;
    for (const std::string &candidate : candidates)
      {
        const unsigned int distance = edit_distance(word, candidate);
        if (distance <= least && (best.empty() || distance < least))
          {
            least = distance;
            best  = candidate;
          }
      }
    return best;
  }
} // namespace lumbricus
