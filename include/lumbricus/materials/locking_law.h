// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_materials_locking_law_h
#define lumbricus_materials_locking_law_h

#include <lumbricus/core/dimension.h>
#include <lumbricus/reference_map/reference_point.h>

#include <deal.II/base/tensor.h>

namespace lumbricus
{
  /** A MaterialLaw that locks: there is a strain that nothing can take it to. */
  class LockingLaw
  {
  public:
    virtual ~LockingLaw() = default;

    /** How near it is to that strain at @p F, from 0 at rest to 1 where it
     * locks. */
    virtual double
    locking(const dealii::Tensor<2, dim> &F,
            const ReferencePoint         &reference) const = 0;
  };
} // namespace lumbricus

#endif
