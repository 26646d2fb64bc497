// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_equilibrium_enclosed_liquid_h
#define lumbricus_equilibrium_enclosed_liquid_h

#include <lumbricus/discretization/body.h>

#include <vector>

namespace lumbricus
{
  /** Whether face @p f of @p cell is on the surface of the body, planes of
   * symmetry apart. */
  bool
  is_outside(const Body                                          &body,
             const dealii::DoFHandler<dim>::active_cell_iterator &cell,
             const unsigned int                                   f);

  /** Which segments have cells of liquid. Collective. */
  std::vector<bool>
  segments_with_liquid(const Body &body);

  /** Whether there are cells of liquid, with wall all around: there is none on
   * the surface of the body, where nothing would hold the nodes of a liquid that
   * flows. Collective. */
  bool
  has_enclosed_liquid(const Body &body);
} // namespace lumbricus

#endif
