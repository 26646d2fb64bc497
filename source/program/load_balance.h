// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_load_balance_h
#define lumbricus_program_load_balance_h

#include <lumbricus/measures/external_forces.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /**
   * Throw ExcInput where the resultant of tractions and body forces at rest, at
   * one of @p times, drives rigid motions that only the minimal support holds. It
   * holds them at single points, whose displacement under a force has no limit
   * when the mesh is refined. Where one of them follows the deformation this
   * is known only later: see imbalance(). Collective.
   */
  void
  check_load_balance(const Body                &body,
                     const BoundaryConditions  &conditions,
                     const BodyForces          &forces,
                     const LiquidWeight        &liquid_weight,
                     const Supports            &supports,
                     const std::vector<double> &times);

  /** Where the minimal support pulls although it must not, what it pulls with
   * and what to do, a sentence; empty where it does not. */
  std::string
  imbalance(const std::vector<ExternalForce> &forces);
} // namespace lumbricus

#endif
