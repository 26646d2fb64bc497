// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_output_field_point_h
#define lumbricus_output_field_point_h

#include <lumbricus/discretization/liquid_weight.h>
#include <lumbricus/discretization/reference_field.h>

#include <deal.II/base/point.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>
#include <deal.II/grid/tria.h>

#include <functional>

namespace lumbricus
{
  /** What there is to know of a state at one point of the body. */
  struct FieldPoint
  {
    /** The cell it is in, one of this rank's. */
    dealii::Triangulation<dim>::active_cell_iterator cell;
    /** Which of the quadrature points of the cell it is. */
    unsigned int q = 0;
    /** State::time. */
    double t = 0.;

    dealii::Point<dim> X;       ///< where it is at rest [mm]
    double             dV = 0.; ///< the volume at rest it stands for [mm^3]

    unsigned int  segment   = 1;       ///< from 1, the head's
    unsigned int  tissue    = 0;       ///< Region::tissue
    bool          is_liquid = false;   ///< whether that is a liquid
    /** That tissue; null in a chamber without cells. */
    const Tissue *material = nullptr;

    dealii::Tensor<1, dim>          u;      ///< displacement [mm]
    dealii::Tensor<2, dim>          F;      ///< I + du/dX, [i][J]
    double                          J = 1.; ///< det F
    dealii::SymmetricTensor<2, dim> sigma;  ///< Cauchy stress [N/mm^2]
    /** -tr sigma / 3, positive in compression [N/mm^2]. */
    double pressure = 0.;
    /** The pressure variable p, positive in tension [N/mm^2]. */
    double pressure_unknown = 0.;

    /** The muscle asked about; null for a field that is not per muscle. */
    const Muscle *muscle = nullptr;

    /** Fibre and activation of that muscle here; null where the tissue does not
     * have it. */
    const MuscleFibre *
    fibre() const;

    /** What the material is here besides its deformation; never null. */
    const MaterialPoint *reference = nullptr;
  };



  /**
   * Call @p visit at the quadrature points of all cells that this rank owns, in
   * the order of the cells: sums over them need a sum over the ranks. The
   * references and the weight have to be those of @p state. Collective.
   */
  void
  visit_points(const Body                              &body,
               const ReferenceField                    &references,
               const LiquidWeight                      &weight,
               const State                             &state,
               const std::function<void(FieldPoint &)> &visit);
} // namespace lumbricus

#endif
