// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_reference_field_h
#define lumbricus_discretization_reference_field_h

#include <lumbricus/discretization/body.h>
#include <lumbricus/reference_map/fluid_reset.h>

#include <vector>

namespace lumbricus
{
  /**
   * The MaterialPoint at every quadrature point of the locally owned cells: the
   * fibres of muscles with what they make of the reference map, the rest shape
   * of the liquid, the identity elsewhere. The only place that knows which
   * cells are which.
   */
  class ReferenceField
  {
  public:
    /** Without points before reinit(). */
    explicit ReferenceField(const Body &body);

    /**
     * Compute the fibre directions, after every change of the mesh.
     * Throws ExcInput where a fibre field has no direction. Collective.
     */
    void
    reinit();

    /**
     * Set the activation of all muscles at time @p t, as that of a body that
     * stands still. Throws ExcInput where a
     * muscle's action cannot take it. Collective.
     */
    void
    update_muscles(const LoadTime &t);

    /** Set how long the fibres were when the last load step ended, and how long
     * before @p t that was, where muscles ask for it. */
    void
    update_speed(const State &state, const LoadTime &t);

    /** Set what viscous branches have of their past in a step that ends at
     * @p t. */
    void
    update_branches(const State &state, const LoadTime &t);

    /** Set the liquid's rest shape and volume. */
    void
    update_liquid(const State &state);

    /** Let the liquid flow, or no longer, as ReferencePoint::flows says: its rest
     * shape is then without meaning, its stress-free volume as it was set. */
    void
    let_liquid_flow(const bool flows);

    /** Set all from a state, with loads taken at @p t. Throws ExcInput.
     * Collective. */
    void
    update(const State &state, const LoadTime &t);

    /** Set all from a state, with loads taken at its time. */
    void
    update(const State &state);

    /** The material points at the quadrature points of an owned cell. */
    const MaterialPoint *
    cell(const unsigned int owned_index) const;

  private:
    const Body                 body;
    std::vector<MaterialPoint> points;
  };
} // namespace lumbricus

#endif
