// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_discretization_remembering_cells_h
#define lumbricus_discretization_remembering_cells_h

#include <lumbricus/discretization/body.h>
#include <lumbricus/terms/boundary_conditions.h>

#include <set>

namespace lumbricus
{
  /** Call @p function(cell, numbers) for all owned cells on whose faces conditions
   * act that remember, with the numbers of these. */
  template <typename Function>
  void
  for_each_remembering_cell(const Body               &body,
                            const BoundaryConditions &conditions,
                            const Function           &function)
  {
    for (const OwnedCell cell : body.owned_cells())
      {
        if (!cell.iterator->at_boundary())
          continue;
        std::set<unsigned int> numbers;
        for (const auto &face : cell.iterator->face_iterators())
          if (face->at_boundary())
            for (const unsigned int number :
                 conditions.surface_terms_on(face->boundary_id()))
              if (conditions.condition(number).surface_term()->remembers())
                numbers.insert(number);
        if (!numbers.empty())
          function(cell, numbers);
      }
  }
} // namespace lumbricus

#endif
