// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_measures_locking_h
#define lumbricus_measures_locking_h

#include <lumbricus/core/state.h>
#include <lumbricus/discretization/body.h>
#include <lumbricus/discretization/reference_field.h>

#include <deal.II/base/point.h>

#include <map>

namespace lumbricus
{
  /** Where a tissue is nearest to the strain at which its LockingLaw locks. */
  struct Locking
  {
    double          share   = 0.; ///< of LockingLaw::locking(), at its largest
    unsigned int    segment = 0;  ///< from 1
    dealii::Point<dim> X;         ///< at rest [mm]
  };

  /** That of every tissue whose law locks, by its number, at @p state, which
   * @p references belong to. Collective. */
  std::map<unsigned int, Locking>
  locking_of_tissues(const Body           &body,
                     const ReferenceField &references,
                     const State          &state);
} // namespace lumbricus

#endif
