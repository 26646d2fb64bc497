// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/displacement_before.h>

#include "nodal_displacement.h"

namespace lumbricus
{
  const NodalHistory displacement_before{"u_before", NodalHistory::Runs::some};



  bool
  muscles_feel_speed(const Anatomy &anatomy)
  {
    for (unsigned int i = 0; i < anatomy.n_muscles(); ++i)
      if (anatomy.muscle(i).action().feels_speed())
        return true;
    return false;
  }



  bool
  way_counts(const Anatomy &anatomy)
  {
    return muscles_feel_speed(anatomy) || anatomy.n_viscous_branches() > 0;
  }



  void
  remember_displacement(const Body &body, State &state)
  {
    if (!way_counts(body.anatomy))
      return;
    write_history(body.space, state.solution, displacement_before.in(state));
  }
} // namespace lumbricus
