// SPDX-License-Identifier: LGPL-2.1-or-later
#include "closed_surface.h"

#include <algorithm>
#include <array>
#include <map>

namespace lumbricus
{
  namespace
  {
    bool
    is_held(const dealii::types::boundary_id id,
            const BoundaryConditions        &conditions)
    {
      std::array<bool, dim> held = {};
      for (const unsigned int i : conditions.prescribed_displacements_on(id))
        {
          const auto components =
            conditions.condition(i).prescribed_displacement()->components();
          for (unsigned int c = 0; c < dim; ++c)
            held[c] = held[c] || components[c];
        }
      return std::all_of(held.begin(), held.end(), [](const bool h) {
        return h;
      });
    }
  } // namespace



  bool
  is_closed_surface(const std::set<dealii::types::boundary_id> &boundaries,
                    const dealii::Triangulation<dim>           &triangulation,
                    const Geometry                             &geometry,
                    const BoundaryConditions                   &conditions)
  {
    std::set<dealii::types::boundary_id> ends;
    for (const SymmetryPlane &plane : geometry.symmetry_planes())
      ends.insert(plane.boundary);
    std::map<unsigned int, unsigned int> n_faces; // at a line of the surface
    std::set<unsigned int>               may_end; // lines
    for (const auto &cell : triangulation.cell_iterators_on_level(0))
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          for (unsigned int l = 0; l < face->n_lines(); ++l)
            {
              const auto         id   = face->boundary_id();
              const unsigned int line = face->line_index(l);
              if (boundaries.count(id) > 0)
                ++n_faces[line];
              if (ends.count(id) > 0 || is_held(id, conditions))
                may_end.insert(line);
            }
    return std::all_of(n_faces.begin(), n_faces.end(), [&](const auto &entry) {
      return entry.second % 2 == 0 || may_end.count(entry.first) > 0;
    });
  }
} // namespace lumbricus
