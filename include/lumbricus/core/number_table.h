// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_number_table_h
#define lumbricus_core_number_table_h

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * A text file of the user's with a line of names and below it lines with a
   * number for each, separated by commas, of which the first increases from
   * line to line:
   *
   *   t,   1,   2    # what follows a # is left out, and empty lines are
   *   0,   1,   1
   *   0.1, 0.9, 1
   */
  class NumberTable
  {
  public:
    /** What is wrong with the names of the columns; empty where nothing is. */
    using CheckNames =
      std::function<std::string(const std::vector<std::string> &)>;

    /** Nothing: no columns and no rows. */
    NumberTable() = default;

    /**
     * The table in @p file, whose names @p check has to accept; @p wanted says
     * what the file has to have, where it has no rows. Throws ExcParameter about
     * @p parameter where it cannot be read, with the line, the column and what
     * is there.
     */
    NumberTable(const std::string &parameter,
                const std::string &file,
                const CheckNames  &check,
                const std::string &wanted);

    /** The names of the columns. */
    const std::vector<std::string> &
    columns() const
    {
      return names;
    }

    /** How many rows there are. */
    std::size_t
    n_rows() const
    {
      return lines.size();
    }

    /** The number in row @p row and column @p column, both from 0. */
    double
    value(const std::size_t row, const std::size_t column) const
    {
      return values[row * names.size() + column];
    }

    /** The number of the line in the file of row @p row, from 1. */
    unsigned int
    line(const std::size_t row) const
    {
      return lines[row];
    }

    /** The first row whose number in the first column is greater than @p x;
     * n_rows() where there is none. */
    std::size_t
    row_after(const double x) const;

    /** Throw ExcParameter about the file: it @p what. */
    [[noreturn]] void
    fail(const std::string &what) const;

  private:
    /** Take the line @p text in, which is number @p number and not empty. */
    void
    add(const std::string &text, const unsigned int number);

    std::string               parameter; ///< that names the file
    std::string               file;
    std::vector<std::string>  names;
    std::vector<double>       values; ///< row by row
    std::vector<unsigned int> lines;  ///< of each row
  };
} // namespace lumbricus

#endif
