// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_piston_check_h
#define lumbricus_program_piston_check_h

#include <lumbricus/constraints/supports.h>
#include <lumbricus/discretization/body.h>

#include <vector>

namespace lumbricus
{
  /**
   * Whether the rims of all pistons that close a cavity stay in planes x = const:
   * their displacement along x has to be prescribed, the same at all points of a
   * rim at each of @p times. Throws ExcInput, which names the boundary, the place
   * and how much it is. Collective.
   */
  void
  check_pistons(const Body                &body,
                const Supports            &supports,
                const std::vector<double> &times);
} // namespace lumbricus

#endif
