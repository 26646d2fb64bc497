// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_measures_body_motion_h
#define lumbricus_measures_body_motion_h

#include <lumbricus/discretization/liquid_weight.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

namespace lumbricus
{
  /** Where a body is as a whole. */
  struct BodyMotion
  {
    /** The centre of mass, int rho x dV/int rho dV, of the whole body with what is
     * in its chambers; that of its volume where nothing has a density [mm]. */
    dealii::Point<dim>     centre;
    dealii::Tensor<1, dim> displacement; ///< of the centre, from rest [mm]
    double head   = 0.; ///< SectionMeasures::begin of the first segment [mm]
    double tail   = 0.; ///< SectionMeasures::end of the last segment [mm]
    double length = 0.; ///< of all segments together [mm]
    double stride = 0.; ///< the displacement forward [mm]
    double speed  = 0.; ///< how fast that has grown over a load step [mm/time]
  };

  /**
   * The motion of @p body at @p solution, without a speed. Forward is what the
   * first Contact of @p conditions says, (-1, 0, 0) without one. @p liquids
   * knows what is in the chambers. In planes of symmetry the whole body has its
   * centre, and head and tail are those of the part that is computed. Collective.
   */
  BodyMotion
  body_motion(const Body               &body,
              const BoundaryConditions &conditions,
              LiquidWeight             &liquids,
              const Vector             &solution);
} // namespace lumbricus

#endif
