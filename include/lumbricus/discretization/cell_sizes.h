// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_cell_sizes_h
#define lumbricus_discretization_cell_sizes_h

#include <lumbricus/core/dimension.h>

namespace lumbricus
{
  /** How many of what a cell has: see MixedSpace. Sources that loop over these
   * name them with a using-declaration. */
  namespace cell_sizes
  {
    constexpr unsigned int n_nodes = 27; ///< of displacements
    constexpr unsigned int n_modes = 4;  ///< of the pressure
    constexpr unsigned int n_q     = 27; ///< quadrature points

    /** Unknowns: displacements and pressures. */
    constexpr unsigned int n_per_cell = dim * n_nodes + n_modes;
  } // namespace cell_sizes
} // namespace lumbricus

#endif
