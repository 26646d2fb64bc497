// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/monotone_cubic.h>

namespace lumbricus
{
  double
  monotone_slope(const TableLine &before, const TableLine &after)
  {
    if (!(before.slope * after.slope > 0.))
      return 0.;
    const double w = before.h + 2. * after.h, v = 2. * before.h + after.h;
    return (w + v) / (w / before.slope + v / after.slope);
  }



  CurvePoint
  cubic_on(const TableLine &line,
           const double     value,
           const double     m,
           const double     n,
           const double     s)
  {
    // value + h (m q + c q^2 + b q^3)
    const double q = s / line.h;
    const double b = m + n - 2. * line.slope;
    const double c = 3. * line.slope - 2. * m - n;
    return {value + s * (m + q * (c + q * b)), m + q * (2. * c + 3. * q * b)};
  }
} // namespace lumbricus
