// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_errors_shape_change_h
#define lumbricus_errors_shape_change_h

#include <lumbricus/discretization/body.h>
#include <lumbricus/discretization/cell_unknowns.h>
#include <lumbricus/errors/cut_cells.h>

namespace lumbricus
{
  /**
   * Let the displacement of @p state, on the small cells, which is a function of the
   * large ones, be the same at the same points of the body where the small cells
   * have another shape: a node that is at X' and was at X in the large cell gets
   *
   *   u + Grad u (X' - X),
   *
   * the mean of its cells in proportion to their shear moduli. The function as it is
   * would strain what is stiff and turns.
   * Collective.
   */
  void
  follow_shape(const Body         &large,
               const Body         &small,
               const CellUnknowns &small_unknowns,
               const CutCells     &cells,
               State              &state);
} // namespace lumbricus

#endif
