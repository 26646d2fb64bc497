// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_measure_table_h
#define lumbricus_geometry_measure_table_h

#include <lumbricus/core/number_table.h>

#include <optional>
#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * Measures along a body, from a text file: a column for the place and one for
   * each measure, linear between rows,
   *
   *   place, Radius, Segment length, circular muscle
   *   0,     1.2,    0.98,           0.2
   *   0.1,   3.5,    0.98,           0.2
   *   1,     2.5,    0.98,           0.1
   *
   * The first column is 'place', (s - 1/2)/n of segment s = 1, ..., n, so that
   * the same table does for any number of segments, or 's' itself.
   */
  class MeasureTable
  {
  public:
    /** The name of the parameter that names the file. */
    inline static const std::string entry = "Table of measures";

    /** Nothing: no measure is in it. */
    MeasureTable() = default;

    /** The table in @p file, whose columns have to be among @p known. Throws
     * ExcParameter about @ref entry where it cannot be read, with the number of
     * the line. */
    MeasureTable(const std::string              &file,
                 const std::vector<std::string> &known);

    /** That in column @p name for segment @p s of @p n, from 1; none where there
     * is no such column. Throws ExcParameter where no rows are around it. */
    std::optional<double>
    value(const std::string &name,
          const unsigned int s,
          const unsigned int n) const;

  private:
    std::string file;
    NumberTable table; ///< its first column is the place
  };
} // namespace lumbricus

#endif
