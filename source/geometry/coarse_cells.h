// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_coarse_cells_h
#define lumbricus_geometry_coarse_cells_h

#include <string>

namespace lumbricus
{
  /**
   * Throw ExcInput where the coarse mesh that @p section asks for has so many
   * cells that no rank, each of which has all of it, could hold it.
   */
  void
  check_n_coarse_cells(const std::string &section, const double n);
} // namespace lumbricus

#endif
