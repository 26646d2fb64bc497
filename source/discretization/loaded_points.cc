// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/loaded_points.h>
#include <lumbricus/discretization/same_cell.h>

#include <deal.II/fe/fe_update_flags.h>
#include <deal.II/fe/fe_values.h>

namespace lumbricus
{
  std::vector<LoadedPoint>
  loaded_points(const MixedSpace         &space,
                const BoundaryConditions &conditions)
  {
    std::vector<LoadedPoint>  points;
    dealii::FEFaceValues<dim> face_values(space.mapping,
                                          space.fe,
                                          space.face_quadrature,
                                          dealii::update_quadrature_points |
                                            dealii::update_normal_vectors |
                                            dealii::update_JxW_values);
    for (const auto &cell : space.owned_cells())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          for (const unsigned int i :
               conditions.surface_terms_on(face->boundary_id()))
            {
              face_values.reinit(mesh_cell(cell), face);
              for (const unsigned int q :
                   face_values.quadrature_point_indices())
                points.push_back({i,
                                  cell->material_id(),
                                  face_values.quadrature_point(q),
                                  face_values.normal_vector(q),
                                  face_values.JxW(q)});
            }
    return points;
  }
} // namespace lumbricus
