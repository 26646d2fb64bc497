// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/prm_scanner.h>

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
    std::istringstream       in(text);
    std::string              raw;
    bool                     continued = false;
    for (unsigned int number = 1; std::getline(in, raw); ++number)
      {
        const std::string line =
          dealii::Utilities::trim(raw.substr(0, raw.find('#')));
        const bool        continues = !line.empty() && line.back() == '\\';
        bool              is_section, is_entry;
        const std::string section = behind(line, "subsection", is_section);
        const std::string entry   = behind(line, "set", is_entry);

        if (continued)
          ; // the value of the entry above goes on
        else if (is_section)
          {
            sections.push_back(section);
            lines.push_back({number, join(sections, ""), true});
            lines.back().path.pop_back();
          }
        else if (line == "end" || line == "END")
          {
            if (!sections.empty())
              sections.pop_back();
          }
        else if (is_entry)
          lines.push_back(
            {number,
             join(sections,
                  dealii::Utilities::trim(entry.substr(0, entry.find('=')))),
             false});
        continued = continues;
      }
    return lines;
  }



  std::vector<std::string>
  split_path(const std::string &path)
  {
    return dealii::Utilities::split_string_list(path, '/');
  }



  std::string
  nearest(const std::string &word, const std::vector<std::string> &candidates)
  {
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
