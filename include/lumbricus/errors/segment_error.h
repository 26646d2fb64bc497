// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_errors_segment_error_h
#define lumbricus_errors_segment_error_h

namespace lumbricus
{
  /** What is estimated to be missing in the numbers of a segment: what smaller cells,
   * shorter steps or more resets would have, minus what there is. NaN where there is
   * no estimate. */
  struct SegmentError
  {
    double length     = 0.; ///< of SectionMeasures::length [mm]
    double mid_radius = 0.; ///< of SectionMeasures::mid_radius [mm]
    double pressure   = 0.; ///< of SegmentState::mean_pressure() [N/mm^2]
    double position   = 0.; ///< of SectionMeasures::middle() [mm]
  };
} // namespace lumbricus

#endif
