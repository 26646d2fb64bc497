// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_anatomy_material_point_h
#define lumbricus_anatomy_material_point_h

#include <lumbricus/action/muscle_action.h>
#include <lumbricus/anatomy/viscous_point.h>
#include <lumbricus/reference_map/reference_point.h>

#include <vector>

namespace lumbricus
{
  /** What is known of a point of a tissue besides its deformation; by default a
   * passive one at rest. */
  struct MaterialPoint
  {
    /** G^(-1) and J_v. */
    ReferencePoint reference;
    /** The fibres of Tissue::muscles(), in their order. */
    std::vector<MuscleFibre> fibres;
    /** Tissue::elastic_fibres(). */
    std::vector<dealii::Tensor<1, dim>> elastic_fibres;
    /** What Tissue::viscous_branches() remember, in their order. */
    std::vector<ViscousPoint> viscous;
  };
} // namespace lumbricus

#endif
