// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_measures_segment_state_h
#define lumbricus_measures_segment_state_h

#include <lumbricus/discretization/cell_unknowns.h>
#include <lumbricus/discretization/reference_field.h>

#include <utility>
#include <vector>

namespace lumbricus
{
  /** Integrals over the deformed liquid and wall of a segment. */
  struct SegmentState
  {
    double liquid_volume = 0.; ///< [mm^3], of the whole cross-section
    double wall_volume   = 0.; ///< [mm^3], all that is not liquid
    double pressure      = 0.; ///< int p dv over the liquid [N mm]
    double abs_pressure  = 0.; ///< int |p| dv over the liquid [N mm]
    double abs_deviator  = 0.; ///< int |dev sigma| dv over the liquid [N mm]
    double largest_deviator =
      0.; ///< largest |dev sigma| in the liquid [N/mm^2]

    /** The liquid's mean pressure, positive in compression [N/mm^2]. */
    double
    mean_pressure() const;

    /**
     * The divergence from the hydrostatic state, eta = int |dev sigma| dv /
     * int |p| dv over the liquid. Where the mean of |p| is below
     * @p pressure_floor that is taken instead, so that a body without load
     * counts as hydrostatic.
     */
    double
    divergence(const double pressure_floor) const;
  };

  /** The integrals of every segment at @p relevant_solution, a ghosted vector,
   * and @p globals, which have the pressures of chambers without cells.
   * Collective. */
  std::vector<SegmentState>
  segment_states(const Body           &body,
                 const ReferenceField &references,
                 const Vector         &relevant_solution,
                 const Globals        &globals);

  /**
   * How the mean pressure of every segment changes with a small change of
   * @p relevant_solution and @p globals, where the liquid is hydrostatic: then it
   * does not hang on displacements, and where cells of liquid fold with them, which
   * means nothing to a liquid, this does not see it. The change is that of all
   * unknowns, constrained or not, in a vector made by CellUnknowns::reinit_vector()
   * with its ghost values. Collective.
   */
  std::vector<double>
  pressure_changes(const Body           &body,
                   const CellUnknowns   &unknowns,
                   const ReferenceField &references,
                   const Vector         &relevant_solution,
                   const Globals        &globals,
                   const Vector         &relevant_change,
                   const Globals        &change_of_globals);

  /** The derivative of sum_s of_pressures_s pressure_changes_s, with a factor for
   * each segment, by the free unknowns and by the global ones. Collective. */
  std::pair<Vector, Globals>
  pressure_derivative(const Body                &body,
                      const CellUnknowns        &unknowns,
                      const ReferenceField      &references,
                      const std::vector<double> &of_pressures,
                      const Vector              &relevant_solution,
                      const Globals             &globals);
} // namespace lumbricus

#endif
