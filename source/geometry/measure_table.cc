// SPDX-License-Identifier: LGPL-2.1-or-later
#include "measure_table.h"

#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/number_in_text.h>
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
    const std::string by_place = "place", by_segment = "s";



    // The words of a line between commas, without its comment.
    std::vector<std::string>
    cells_of(std::string line)
    {
      line.resize(std::min(line.find('#'), line.size()));
      if (dealii::Utilities::trim(line).empty())
        return {};
      return dealii::Utilities::split_string_list(line, ',');
    }
  } // namespace



  MeasureTable::MeasureTable(const std::string              &file,
                             const std::vector<std::string> &known)
    : file(file)
  {
    const auto fail = [&](const std::string &what) {
      AssertThrow(false, ExcParameter(entry, ": the file '" + file + "' " + what));
    };
    std::ifstream in = open_input_file(file);
    if (!in.good())
      fail("cannot be read. Give its path from the working directory.");

    const std::string first_columns =
      "the first column is 'place', (s - 1/2)/n from 0 at the head to 1 at the "
      "tail, or 's', the number of the segment";
    std::string line;
    skip_byte_order_mark(in);
    for (unsigned int number = 1; read_line(in, line); ++number)
      {
        const auto cells = cells_of(line);
        if (cells.empty())
          continue;
        const std::string at = "line " + std::to_string(number) + ": ";
        if (columns.empty())
          {
            columns = cells;
            if (columns[0] != by_place && columns[0] != by_segment)
              fail(at + first_columns + ", not '" + shortened(columns[0]) + "'.");
            std::set<std::string> names;
            for (const std::string &name : columns)
              if (!names.insert(name).second)
                fail(at + "the column '" + shortened(name) + "' is there twice.");
            for (unsigned int c = 1; c < columns.size(); ++c)
              if (std::find(known.begin(), known.end(), columns[c]) ==
                  known.end())
                {
                  std::string all;
                  for (const std::string &name : known)
                    all += (all.empty() ? "'" : ", '") + name + "'";
                  fail(at + "'" + shortened(columns[c]) +
                       "' is no measure of this body. It has " + all + ".");
                }
            continue;
          }
        if (cells.size() != columns.size())
          fail(at + "it has " + std::to_string(cells.size()) +
               " numbers for " + std::to_string(columns.size()) + " columns.");
        std::vector<double> row(cells.size());
        for (unsigned int c = 0; c < cells.size(); ++c)
          if (!read_number(cells[c], row[c]))
            fail(at + "'" + shortened(cells[c]) + "' is no number.");
        if (!rows.empty() && row[0] <= rows.back()[0])
          fail(at + "the column '" + columns[0] + "' has to increase.");
        rows.push_back(row);
      }
    if (rows.empty())
      fail("has no rows. Give a line with names, where " + first_columns +
           ", and below it one with numbers for each place.");
  }



  std::optional<double>
  MeasureTable::value(const std::string &name,
                      const unsigned int s,
                      const unsigned int n) const
  {
    const auto column = std::find(columns.begin(), columns.end(), name);
    if (column == columns.end())
      return {};
    const auto   c     = column - columns.begin();
    const double place = columns[0] == by_segment ? s : (s - 0.5) / n;
    AssertThrow(place >= rows.front()[0] && place <= rows.back()[0],
                ExcParameter(entry,
                             ": the file '" + file + "' is from " + columns[0] +
                               " = " +
                               dealii::Utilities::to_string(rows.front()[0]) +
                               " to " +
                               dealii::Utilities::to_string(rows.back()[0]) +
                               ", but segment " + std::to_string(s) + " of " +
                               std::to_string(n) + " is at " +
                               dealii::Utilities::to_string(place) + "."));
    const auto next =
      std::lower_bound(rows.begin(),
                       rows.end(),
                       place,
                       [](const std::vector<double> &row, const double x) {
                         return row[0] < x;
                       });
    if ((*next)[0] == place)
      return (*next)[c];
    const auto  &last = *(next - 1);
    const double f    = (place - last[0]) / ((*next)[0] - last[0]);
    return (1. - f) * last[c] + f * (*next)[c];
  }
} // namespace lumbricus
