// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_measures_section_measures_h
#define lumbricus_measures_section_measures_h

#include <lumbricus/discretization/body.h>
#include <lumbricus/discretization/cell_unknowns.h>

#include <deal.II/base/tensor.h>

#include <vector>

namespace lumbricus
{
  /** The shape of a segment in two numbers [mm]. */
  struct SectionMeasures
  {
    /** Distance of the mean positions of the wall's two end sections. */
    double length;
    /**
     * Radius of the circle with the area of the deformed section in the middle
     * of the segment, of the liquid where there is some, else of all. NaN
     * where no mesh faces lie in that section.
     */
    double mid_radius;
    double begin; ///< the mean x of that end section towards the head
    double end;   ///< the mean x of the one towards the tail
    /** From the one to the other, but for what lies in no plane of symmetry. */
    dealii::Tensor<1, dim> axis;

    /** Where the segment is: the x in the middle of both end sections. */
    double
    middle() const
    {
      return 0.5 * (begin + end);
    }
  };

  /** The measures of every segment at @p relevant_solution, a ghosted vector.
   * Collective. */
  std::vector<SectionMeasures>
  section_measures(const Body &body, const Vector &relevant_solution);

  /**
   * The derivative of
   *
   *   sum_s of_lengths_s length_s + of_radii_s mid_radius_s
   *
   * by the free unknowns, at @p relevant_solution, a ghosted vector, with two
   * factors for each segment. Where that is 0 the measure need not exist. Collective.
   */
  Vector
  section_derivative(const Body                &body,
                     const CellUnknowns        &unknowns,
                     const std::vector<double> &of_lengths,
                     const std::vector<double> &of_radii,
                     const Vector              &relevant_solution);
} // namespace lumbricus

#endif
