// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/output/table_rows.h>

#include <deal.II/base/exceptions.h>

namespace lumbricus
{
  namespace
  {
    // @p text as an entry: in quotes where it needs them.
    std::string
    entry_of(const std::string &text)
    {
      if (text.find_first_of(",\"\n\r") == std::string::npos)
        return text;
      std::string quoted = "\"";
      for (const char c : text)
        quoted += c == '"' ? "\"\"" : std::string(1, c);
      return quoted + "\"";
    }
  } // namespace



  TableRows::TableRows(const std::vector<std::string> &columns)
    : n_columns(columns.size())
  {
    for (const std::string &column : columns)
      names += (names.empty() ? "" : ",") + entry_of(column);
    names += '\n';
    number.precision(15);
  }



  TableRows &
  TableRows::operator<<(const std::string &text)
  {
    rows += (n_entries == 0 ? "" : ",") + entry_of(text);
    ++n_entries;
    return *this;
  }



  TableRows &
  TableRows::operator<<(const char *text)
  {
    return *this << std::string(text);
  }



  void
  TableRows::end_row()
  {
    AssertThrow(n_entries == n_columns,
                dealii::ExcDimensionMismatch(n_entries, n_columns));
    rows += '\n';
    n_entries = 0;
  }



  const std::string &
  TableRows::first_line() const
  {
    return names;
  }



  std::string
  TableRows::take()
  {
    std::string all;
    all.swap(rows);
    return all;
  }
} // namespace lumbricus
