// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_measures_contact_state_h
#define lumbricus_measures_contact_state_h

#include <lumbricus/discretization/surface_terms.h>

#include <deal.II/base/tensor.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * What an obstacle does to the skin of a segment, of the part of the body that
   * is computed: integrals over areas at rest, with the weights of the nodes
   * that SurfaceTerms has.
   */
  struct ContactState
  {
    std::string  name;         ///< that of the condition
    unsigned int segment = 0;  ///< from zero
    /** int p dA [N]. */
    double                 normal_force = 0.;
    dealii::Tensor<1, dim> force;    ///< int T dA on the body [N]
    dealii::Tensor<1, dim> friction; ///< int (T - p n) dA on the body [N]
    double area = 0.;        ///< where it touches [mm^2]
    double penetration = 0.; ///< the largest -g there, at least 0 [mm]
    /** Where it touches, or is held by mucus [mm^2]. */
    double area_in_touch = 0.;
    /** The part of that where it slides, or nothing holds it [mm^2]. */
    double sliding_area = 0.;

    /** The part that slides, of all that is in touch; 0 where nothing is. */
    double
    sliding_part() const;

    /** Whether something is in touch and less than half of it slides. */
    bool
    is_anchored() const;
  };

  /**
   * An entry for every Contact of @p conditions, in their order, and every
   * segment that has skin there, at @p solution and the loads of @p t. @p terms
   * are set to that state, in which the step has not ended: then the skin forgets
   * how far it has slid. Collective.
   */
  std::vector<ContactState>
  contact_states(const Body               &body,
                 const BoundaryConditions &conditions,
                 SurfaceTerms             &terms,
                 const Vector             &solution,
                 const LoadTime           &t);
} // namespace lumbricus

#endif
