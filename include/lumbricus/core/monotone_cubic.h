// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_monotone_cubic_h
#define lumbricus_core_monotone_cubic_h

#include <lumbricus/core/curve_point.h>

namespace lumbricus
{
  /** What is between two rows of a table: as far as @p h apart, and a straight
   * line of this @p slope from one to the other. */
  struct TableLine
  {
    double h;     ///< of the first column
    double slope; ///< per unit of the first column
  };

  /**
   * The slope of a monotone cubic interpolation ("pchip") at a row between two
   * lines: their weighted harmonic mean, 0 where they have not the same sign
   *
   *   m = (w_1 + w_2) / (w_1/s_1 + w_2/s_2),  w_1 = h_1 + 2 h_2, w_2 = 2 h_1 + h_2
   *
   * (Fritsch and Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300-304, with the
   * weights of Brodlie). Between rows the curve is then as monotone as they are.
   */
  double
  monotone_slope(const TableLine &before, const TableLine &after);

  /**
   * The cubic that begins at @p value with the slope @p m and ends on @p line
   * with the slope @p n, at the distance @p s from where it begins.
   */
  CurvePoint
  cubic_on(const TableLine &line,
           const double     value,
           const double     m,
           const double     n,
           const double     s);
} // namespace lumbricus

#endif
