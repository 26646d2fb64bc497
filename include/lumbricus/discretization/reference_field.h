// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_reference_field_h
#define lumbricus_discretization_reference_field_h

#include <lumbricus/anatomy/anatomy.h>
#include <lumbricus/discretization/shape_cache.h>
#include <lumbricus/reference_map/active_stretch.h>
#include <lumbricus/reference_map/fluid_reset.h>

#include <vector>

namespace lumbricus
{
  /**
   * The reference map at every quadrature point of the locally owned cells:
   * the active stretch of muscles, the rest shape of the liquid, the identity
   * elsewhere. The only place that knows which cells are which.
   */
  class ReferenceField
  {
  public:
    /** On the mesh of @p space; all of these are kept by reference. */
    ReferenceField(const MixedSpace &space,
                   const ShapeCache &shapes,
                   const Anatomy    &anatomy);

    /**
     * Compute the fibre directions, after every change of the mesh.
     * Throws ExcInput where a fibre field has no direction. Collective.
     */
    void
    reinit();

    /**
     * Set the active stretch of all muscles at time @p t. Throws ExcInput
     * where a stretch is not a positive number. Collective.
     */
    void
    update_muscles(const LoadTime &t);

    /** Set the liquid's rest shape and volume. */
    void
    update_liquid(const State &state);

    /** Set all from a state, with loads taken at @p t. Throws ExcInput.
     * Collective. */
    void
    update(const State &state, const LoadTime &t);

    /** The same at the time of @p state. */
    void
    update(const State &state);

    /** The maps at the quadrature points of an owned cell. */
    const ReferencePoint *
    cell(const unsigned int owned_index) const;

    /**
     * Fibre directions and active stretches at the quadrature points of an
     * owned cell: [q][muscle of the tissue], in the order of
     * Anatomy::muscles_of(). Empty where there are no muscles.
     */
    const std::vector<std::vector<ActiveFibre>> &
    fibres(const unsigned int owned_index) const;

  private:
    const MixedSpace &space;
    const ShapeCache &shapes;
    const Anatomy    &anatomy;

    std::vector<ReferencePoint>                        points;
    std::vector<std::vector<std::vector<ActiveFibre>>> active_fibres;
  };
} // namespace lumbricus

#endif
