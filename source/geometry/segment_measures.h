// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_geometry_segment_measures_h
#define lumbricus_geometry_segment_measures_h

#include <lumbricus/parameters/parameter_owner.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * The measures of one segment of a chain. Declared once for the whole
   * chain, and once for every range of segments that has its own.
   */
  struct SegmentMeasures : public ParameterOwner
  {
    /** Declare with the present values as defaults, which stay exact. */
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    /** Inner radius of the wall [mm]. */
    double radius = 2.;
    /** Length of the liquid chamber, between septa or caps [mm]. */
    double length = 2.;
    /** Thickness of the septum towards the tail [mm], half of which belongs to
     * the next segment. */
    double septum_thickness = 0.1;
    /** Of the layers of the wall, from inside to outside [mm]. */
    std::vector<double> layer_thicknesses = {0.15, 0.15};
    /** What is in the chamber: "meshed", or "cavity" where no cells are. */
    std::string liquid = "meshed";
  };
} // namespace lumbricus

#endif
