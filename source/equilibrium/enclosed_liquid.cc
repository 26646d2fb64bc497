// SPDX-License-Identifier: LGPL-2.1-or-later
#include "enclosed_liquid.h"

#include <algorithm>

namespace lumbricus
{
  bool
  is_outside(const Body                                          &body,
             const dealii::DoFHandler<dim>::active_cell_iterator &cell,
             const unsigned int                                   f)
  {
    if (!cell->face(f)->at_boundary())
      return false;
    const auto planes = body.anatomy.geometry().symmetry_planes();
    return std::none_of(planes.begin(), planes.end(), [&](const auto &plane) {
      return plane.boundary == cell->face(f)->boundary_id();
    });
  }



  std::vector<bool>
  segments_with_liquid(const Body &body)
  {
    std::vector<unsigned int> has_cells(body.anatomy.geometry().n_segments(),
                                        0);
    for (const OwnedCell cell : body.owned_cells())
      if (cell.is_liquid)
        has_cells[cell.region.segment] = 1;
    dealii::Utilities::MPI::max(has_cells,
                                body.space.communicator(),
                                has_cells);
    return {has_cells.begin(), has_cells.end()};
  }



  bool
  has_enclosed_liquid(const Body &body)
  {
    unsigned int n_outside = 0;
    for (const OwnedCell cell : body.owned_cells())
      if (cell.is_liquid)
        for (const unsigned int f : cell.iterator->face_indices())
          n_outside += is_outside(body, cell.iterator, f);
    const auto with_liquid = segments_with_liquid(body);
    return dealii::Utilities::MPI::max(n_outside, body.space.communicator()) ==
             0 &&
           std::find(with_liquid.begin(), with_liquid.end(), true) !=
             with_liquid.end();
  }
} // namespace lumbricus
