// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_volume_terms_h
#define lumbricus_discretization_volume_terms_h

#include <lumbricus/core/load_time.h>
#include <lumbricus/discretization/body.h>
#include <lumbricus/terms/body_forces.h>

#include <functional>

namespace lumbricus
{
  /** Every VolumeTerm on the mesh: b and its derivative at the quadrature points
   * of the cells. */
  class VolumeTerms
  {
  public:
    /** A quadrature point of a cell, with its nodes. */
    struct Point
    {
      dealii::Point<dim> x;      ///< where it is now [mm]
      double             JxW;    ///< volume at rest [mm^3]
      const double      *values; ///< N_n: [n]
    };

    /** Called with the number of a body force, where, and its response. */
    using Listener = std::function<
      void(const unsigned int, const Point &, const VolumeResponse &)>;

    /** Both arguments are kept by reference. */
    VolumeTerms(const Body &body, const BodyForces &forces);

    /** Whether any acts in the tissue of @p cell. */
    bool
    act_in(const OwnedCell &cell) const;

    /** Whether all of them keep the matrix symmetric. */
    bool
    symmetric() const;

    /** Call @p listener at the quadrature points of @p cell for every term that
     * acts there, at the displacements @p u, [i][n], and time @p t. */
    void
    visit(const OwnedCell &cell,
          const double (&u)[dim][ShapeCache::padded_nodes],
          const LoadTime &t,
          const Listener &listener) const;

  private:
    const Body        body;
    const BodyForces &forces;
  };
} // namespace lumbricus

#endif
