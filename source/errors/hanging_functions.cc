// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/errors/hanging_functions.h>

#include <algorithm>
#include <cmath>

namespace lumbricus
{
  HangingFunctions::HangingFunctions(const Body            &body,
                                     const CellUnknowns    &unknowns,
                                     const CutCells        &cells,
                                     const FamilyFunctions &functions)
    : unknowns(unknowns)
  {
    unknowns.reinit_vector(followers);
    unknowns.reinit_vector(of_large_cells);
    for (const OwnedCell cell : body.owned_cells())
      for (unsigned int k = 0; k < CellUnknowns::n_per_cell; ++k)
        if (unknowns.is_constrained(cell.index, k))
          {
            for (const auto &[place, weight] : unknowns.row(cell.index, k))
              followers.local_element(place) += std::abs(weight);
          }
        else if (functions.is_of_large_cell(cells.child(cell.index), k))
          of_large_cells.local_element(unknowns.places(cell.index)[k]) += 1.;
    for (Vector *const x : {&followers, &of_large_cells})
      {
        x->compress(dealii::VectorOperation::add);
        x->update_ghost_values();
      }
  }



  HangingFunctions::OfFamily
  HangingFunctions::of_family(
    const std::array<unsigned int, FamilyFunctions::n_children> &children) const
  {
    OfFamily   result;
    const auto add = [&](const unsigned int child,
                         const unsigned int row,
                         const unsigned int place,
                         const double       weight) {
      if (weight == 0. || !leads(place) ||
          of_large_cells.local_element(place) > 0.)
        return;
      auto      &places = result.places;
      const auto found  = std::find(places.begin(), places.end(), place);
      result.entries.push_back(
        {child,
         row,
         static_cast<unsigned int>(found - places.begin()),
         weight});
      if (found == places.end())
        places.push_back(place);
    };
    for (unsigned int c = 0; c < children.size(); ++c)
      for (unsigned int k = 0; k < CellUnknowns::n_per_cell; ++k)
        if (!unknowns.is_constrained(children[c], k))
          add(c, k, unknowns.places(children[c])[k], 1.);
        else
          for (const auto &[place, weight] : unknowns.row(children[c], k))
            add(c, k, place, weight);
    return result;
  }
} // namespace lumbricus
