// SPDX-License-Identifier: LGPL-2.1-or-later
#include "segment_measures.h"

#include <lumbricus/parameters/patterns.h>

namespace lumbricus
{
  void
  SegmentMeasures::declare_parameters(dealii::ParameterHandler &prm)
  {
    // Some versions of deal.II read the default back from its text, which has
    // six digits only.
    const SegmentMeasures exact = *this;

    prm.add_parameter("Radius",
                      radius,
                      "[mm] Radius of the liquid chamber, which is the inner "
                      "radius of the wall.",
                      PositiveNumber());
    prm.add_parameter("Segment length",
                      length,
                      "[mm] Length of the liquid chamber along the axis, "
                      "between the septa or caps that close it.",
                      PositiveNumber());
    prm.add_parameter("Wall layer thicknesses",
                      layer_thicknesses,
                      "[mm] Thickness of each layer of the wall, from inside "
                      "to outside, separated by commas.",
                      dealii::Patterns::List(PositiveNumber(), 1, 64));
    prm.add_parameter(
      "Septum thickness",
      septum_thickness,
      "[mm] Thickness of the septum behind the segment, towards "
      "the tail. Its front half belongs to this segment, its "
      "rear half to the next. Where neighbours differ in radius "
      "or wall, the septum is where one changes into the other.",
      PositiveNumber());
    prm.add_parameter("Liquid",
                      liquid,
                      "What is in the chamber. 'meshed': cells of the tissue "
                      "'liquid', a soft rubber that is reset. 'cavity': no "
                      "cells, but one pressure, see Cavities.",
                      dealii::Patterns::Selection("meshed|cavity"));

    *this = exact;
  }
} // namespace lumbricus
