// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/number_in_text.h>
#include <lumbricus/core/number_table.h>
#include <lumbricus/core/readable_file.h>
#include <lumbricus/core/text_lines.h>
#include <lumbricus/core/user_text.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <fstream>
#include <set>

namespace lumbricus
{
  namespace
  {
    // What is between the commas of a line, those that are empty too.
    std::vector<std::string>
    cells_of(const std::string &line)
    {
      std::vector<std::string> cells;
      for (std::size_t begin = 0; begin <= line.size();)
        {
          const std::size_t end = std::min(line.find(',', begin), line.size());
          cells.push_back(
            dealii::Utilities::trim(line.substr(begin, end - begin)));
          begin = end + 1;
        }
      return cells;
    }
  } // namespace



  NumberTable::NumberTable(const std::string &parameter,
                           const std::string &file,
                           const CheckNames  &check,
                           const std::string &wanted)
    : parameter(parameter)
    , file(file)
  {
    std::ifstream in = open_input_file(file);
    if (!in.good())
      fail("cannot be read: " + why_unreadable(file) +
           ". Give its path from the working directory.");
    std::string line;
    skip_byte_order_mark(in);
    for (unsigned int number = 1; read_line(in, line); ++number)
      {
        line.resize(std::min(line.find('#'), line.size()));
        if (dealii::Utilities::trim(line).empty())
          continue;
        if (!names.empty())
          {
            add(line, number);
            continue;
          }
        names                = cells_of(line);
        const std::string at = "line " + std::to_string(number) + ": ";
        std::set<std::string> seen;
        for (const std::string &name : names)
          if (!seen.insert(name).second)
            fail(at + "the column '" + shortened(name) + "' is there twice.");
        const std::string wrong = check(names);
        if (!wrong.empty())
          fail(at + wrong);
      }
    if (lines.empty())
      fail("has no rows. " + wanted);
  }



  void
  NumberTable::add(const std::string &text, const unsigned int number)
  {
    const auto        cells = cells_of(text);
    const std::string at    = "line " + std::to_string(number);
    if (cells.size() != names.size())
      fail(at + ": it has " + std::to_string(cells.size()) + " numbers for " +
           std::to_string(names.size()) + " columns.");
    for (std::size_t c = 0; c < cells.size(); ++c)
      {
        double value = 0.;
        if (!read_number(cells[c], value))
          fail(at + ", column '" + shortened(names[c]) + "': " +
               (cells[c].empty() ?
                  "there is nothing; each row needs a number in each column." :
                  "'" + shortened(cells[c]) + "' is no number."));
        values.push_back(value);
      }
    const std::size_t row = lines.size();
    lines.push_back(number);
    if (row > 0 && value(row, 0) <= value(row - 1, 0))
      fail(at + ", column '" + names[0] + "': " + shortened(cells[0]) +
           " is not greater than that in the row before; the column '" +
           names[0] + "' has to increase.");
  }



  std::size_t
  NumberTable::row_after(const double x) const
  {
    std::size_t first = 0, last = n_rows();
    while (first < last)
      {
        const std::size_t middle = first + (last - first) / 2;
        if (value(middle, 0) > x)
          last = middle;
        else
          first = middle + 1;
      }
    return first;
  }



  void
  NumberTable::fail(const std::string &what) const
  {
    throw ExcParameter(parameter, ": the file '" + file + "' " + what);
  }
} // namespace lumbricus
