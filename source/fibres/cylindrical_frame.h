// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_fibres_cylindrical_frame_h
#define lumbricus_fibres_cylindrical_frame_h

#include <lumbricus/core/dimension.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <string>

namespace lumbricus
{
  /** e_x, the direction of the axis of every body. */
  dealii::Tensor<1, dim>
  axial_direction();

  /**
   * The unit vectors of cylindrical coordinates about the x axis at X,
   *
   *   e_r = (0, y, z)/r,  e_theta = e_x x e_r = (0, -z, y)/r.
   */
  struct CylindricalFrame
  {
    /** Away from the axis. */
    dealii::Tensor<1, dim> e_r;
    /** Around it, from y to z. */
    dealii::Tensor<1, dim> e_theta;

    /**
     * The frame at @p X. Throws ExcInput where X is on the axis; @p field is
     * the fibre field that needs the frame, for the message.
     */
    static CylindricalFrame
    at(const dealii::Point<dim> &X, const std::string &field);
  };
} // namespace lumbricus

#endif
