// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/loaded_points.h>
#include <lumbricus/discretization/same_cell.h>

#include <deal.II/base/quadrature.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/fe/fe_update_flags.h>
#include <deal.II/fe/fe_values.h>

#include <memory>

namespace lumbricus
{
  SurfacePoint
  LoadedPoint::at_rest() const
  {
    SurfacePoint point;
    point.X       = X;
    point.N       = N;
    point.F       = dealii::unit_symmetric_tensor<dim, double>();
    point.segment = Region::of(material).segment;
    point.history = history;
    return point;
  }



  std::vector<LoadedPoint>
  loaded_points(const MixedSpace         &space,
                const BoundaryConditions &conditions)
  {
    std::vector<LoadedPoint>  points;
    const auto values_at = [&](const dealii::Quadrature<dim - 1> &quadrature) {
      return std::make_unique<dealii::FEFaceValues<dim>>(
        space.mapping,
        space.fe,
        quadrature,
        dealii::update_quadrature_points | dealii::update_normal_vectors |
          dealii::update_JxW_values);
    };
    const auto inside = values_at(space.face_quadrature);
    const auto at_nodes =
      values_at(dealii::QGaussLobatto<dim - 1>(MixedSpace::degree + 1));
    for (const auto &cell : space.owned_cells())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          for (const unsigned int i :
               conditions.surface_terms_on(face->boundary_id()))
            {
              const SurfaceTerm &term = *conditions.condition(i).surface_term();
              auto &face_values = term.remembers() ? *at_nodes : *inside;
              face_values.reinit(mesh_cell(cell), face);
              for (const unsigned int q :
                   face_values.quadrature_point_indices())
                {
                  points.push_back({i,
                                    cell->material_id(),
                                    face_values.quadrature_point(q),
                                    face_values.normal_vector(q),
                                    face_values.JxW(q),
                                    {}});
                  // As in the state at rest: what does not touch is apart.
                  LoadedPoint &point = points.back();
                  if (term.remembers())
                    term.remember(point.at_rest(), point.history);
                }
            }
    return points;
  }
} // namespace lumbricus
