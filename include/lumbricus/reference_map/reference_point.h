// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_reference_map_reference_point_h
#define lumbricus_reference_map_reference_point_h

#include <lumbricus/core/dimension.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace lumbricus
{
  /**
   * The reference map at a point: F = F_e G with det G = 1 takes a material
   * point from the mesh's configuration to its own stress-free shape, and J_v
   * is its stress-free volume per volume of the mesh's configuration.
   * A passive solid has G = I and J_v = 1; one that grows has another J_v.
   */
  struct ReferencePoint
  {
    /** G^(-1), which is what laws need. */
    dealii::Tensor<2, dim> G_inverse =
      dealii::unit_symmetric_tensor<dim, double>();
    /** The stress-free volume ratio, > 0. */
    double J_v = 1.;
    /** Of a liquid that flows: the shape that it has is always its stress-free
     * one, and G is not asked for. */
    bool flows = false;
    /** G f for each family of fibres that the law has, f its unit vector at
     * rest: where the fibre is in the stress-free shape, and how long. */
    std::vector<dealii::Tensor<1, dim>> fibres = {};
  };
} // namespace lumbricus

#endif
