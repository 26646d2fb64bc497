// SPDX-License-Identifier: LGPL-2.1-or-later
#include "segment_columns.h"

namespace lumbricus
{
  std::vector<std::string>
  with_segment_columns(std::vector<std::string>        before,
                       const std::vector<std::string> &after)
  {
    for (const std::string column : {"length",
                                     "mid_radius",
                                     "fluid_volume",
                                     "wall_volume",
                                     "fluid_pressure",
                                     "eta"})
      before.push_back(column);
    before.insert(before.end(), after.begin(), after.end());
    return before;
  }



  void
  add_segment(TableRows                   &rows,
              const ResetIteration::Solve &solve,
              const unsigned int           s)
  {
    rows << solve.measures[s].length << solve.measures[s].mid_radius
         << solve.segments[s].liquid_volume << solve.segments[s].wall_volume
         << solve.segments[s].mean_pressure() << solve.divergence[s];
  }
} // namespace lumbricus
