// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_contact_check_h
#define lumbricus_program_contact_check_h

#include <lumbricus/constraints/supports.h>
#include <lumbricus/discretization/body.h>
#include <lumbricus/terms/body_forces.h>
#include <lumbricus/terms/boundary_conditions.h>

#include <vector>

namespace lumbricus
{
  /**
   * Look at every Contact before anything is computed. Throws ExcInput where an
   * obstacle is none at one of @p times, where the skin at rest is inside of one
   * by more than a third of a cell, and where the body does not touch anything,
   * though it weighs and nothing else holds it. Collective.
   */
  void
  check_contacts(const Body                &body,
                 const BoundaryConditions  &conditions,
                 const BodyForces          &forces,
                 const Supports            &supports,
                 const std::vector<double> &times);
} // namespace lumbricus

#endif
