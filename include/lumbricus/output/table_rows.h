// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_output_table_rows_h
#define lumbricus_output_table_rows_h

#include <sstream>
#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * Rows of a table in the comma-separated form of RFC 4180. A row is as many
   * entries as there are columns, and end_row().
   */
  class TableRows
  {
  public:
    /** Begins with the line of their names. */
    explicit TableRows(const std::vector<std::string> &columns);

    /** Add a number to the row being made, with 15 digits. */
    template <typename T>
    TableRows &
    operator<<(const T &entry);

    /** Add a text, in quotes where it needs them. */
    TableRows &
    operator<<(const std::string &text);

    /** Add a text, in quotes where it needs them. */
    TableRows &
    operator<<(const char *text);

    /** End the row, which has to be complete. */
    void
    end_row();

    /** The line of the names of the columns. */
    const std::string &
    first_line() const;

    /** The rows since the last call. */
    std::string
    take();

  private:
    const std::size_t  n_columns;
    std::string        names;
    std::size_t        n_entries = 0;
    std::string        rows;
    std::ostringstream number;
  };



  template <typename T>
  TableRows &
  TableRows::operator<<(const T &entry)
  {
    number.str("");
    number << entry;
    return *this << number.str();
  }
} // namespace lumbricus

#endif
