// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_output_tables_segment_columns_h
#define lumbricus_output_tables_segment_columns_h

#include <lumbricus/equilibrium/reset_iteration.h>
#include <lumbricus/output/table_rows.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /** The columns that segments.csv and resets.csv share, between those that
   * each has alone. */
  std::vector<std::string>
  with_segment_columns(std::vector<std::string>        before,
                       const std::vector<std::string> &after);

  /** The entries of these columns for segment @p s, from 0. */
  void
  add_segment(TableRows                   &rows,
              const ResetIteration::Solve &solve,
              const unsigned int           s);
} // namespace lumbricus

#endif
