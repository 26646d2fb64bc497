// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_curve_point_h
#define lumbricus_core_curve_point_h

namespace lumbricus
{
  /** A value of a curve and its slope there. */
  struct CurvePoint
  {
    double value; ///< f(x)
    double slope; ///< df/dx
  };
} // namespace lumbricus

#endif
