// SPDX-License-Identifier: LGPL-2.1-or-later
#include "measure_table.h"

#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/user_text.h>

#include <deal.II/base/utilities.h>

#include <algorithm>

namespace lumbricus
{
  namespace
  {
    const std::string by_place = "place", by_segment = "s";

    const std::string first_columns =
      "the first column is 'place', (s - 1/2)/n from 0 at the head to 1 at the "
      "tail, or 's', the number of the segment";
  } // namespace



  MeasureTable::MeasureTable(const std::string              &file,
                             const std::vector<std::string> &known)
    : file(file)
    , table(
        entry,
        file,
        [&known](const std::vector<std::string> &columns) {
          if (columns[0] != by_place && columns[0] != by_segment)
            return first_columns + ", not '" + shortened(columns[0]) + "'.";
          std::string all;
          for (const std::string &name : known)
            all += (all.empty() ? "'" : ", '") + name + "'";
          for (unsigned int c = 1; c < columns.size(); ++c)
            if (std::find(known.begin(), known.end(), columns[c]) ==
                known.end())
              return "'" + shortened(columns[c]) +
                     "' is no measure of this body. It has " + all + ".";
          return std::string();
        },
        "Give a line with names, where " + first_columns +
          ", and below it one with numbers for each place.")
  {}



  std::optional<double>
  MeasureTable::value(const std::string &name,
                      const unsigned int s,
                      const unsigned int n) const
  {
    const auto &columns = table.columns();
    const auto  column = std::find(columns.begin(), columns.end(), name);
    if (column == columns.end())
      return {};
    const auto   c     = column - columns.begin();
    const double place = columns[0] == by_segment ? s : (s - 0.5) / n;
    const std::size_t end   = table.n_rows() - 1;
    const double      first = table.value(0, 0), last = table.value(end, 0);
    AssertThrow(place >= first && place <= last,
                ExcParameter(entry,
                             ": the file '" + file + "' is from " + columns[0] +
                               " = " + dealii::Utilities::to_string(first) +
                               " to " + dealii::Utilities::to_string(last) +
                               ", but segment " + std::to_string(s) + " of " +
                               std::to_string(n) + " is at " +
                               dealii::Utilities::to_string(place) + "."));
    const std::size_t row = table.row_after(place) - 1;
    const double      x   = table.value(row, 0);
    if (x == place)
      return table.value(row, c);
    const double f = (place - x) / (table.value(row + 1, 0) - x);
    return (1. - f) * table.value(row, c) + f * table.value(row + 1, c);
  }
} // namespace lumbricus
