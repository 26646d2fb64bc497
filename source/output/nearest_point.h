// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_output_nearest_point_h
#define lumbricus_output_nearest_point_h

#include <lumbricus/core/dimension.h>

#include <deal.II/base/point.h>
#include <deal.II/fe/mapping.h>
#include <deal.II/grid/tria.h>

namespace lumbricus
{
  /** The point of a body that is nearest to one that was asked for. */
  struct NearestPoint
  {
    /** Whether its cell is this rank's. The next two are set only then. */
    bool mine = false;
    /** The cell it is in. */
    dealii::Triangulation<dim>::active_cell_iterator cell = {};
    /** Where in the cell. */
    dealii::Point<dim> unit_point = {};

    /** Where it is; the same on all ranks, as what follows. */
    dealii::Point<dim> position = {};
    /** How far it is from the point asked for; 0 for one in the body. */
    double distance = 0.;
    /** The longest edge of the cell. */
    double cell_size = 0.;
  };

  /**
   * Find it. Of several cells that have it, it is in that with the least
   * dealii::CellId, so that the answer does not depend on the number of ranks.
   * Collective.
   */
  NearestPoint
  nearest_point(const dealii::Point<dim>         &point,
                const dealii::Triangulation<dim> &triangulation,
                const dealii::Mapping<dim>       &mapping);
} // namespace lumbricus

#endif
