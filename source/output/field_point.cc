// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/element_kernel.h>
#include <lumbricus/output/field_point.h>

#include <deal.II/grid/filtered_iterator.h>

#include <algorithm>

namespace lumbricus
{
  const ActiveFibre *
  FieldPoint::fibre() const
  {
    const auto here = std::find(muscles->begin(), muscles->end(), muscle);
    return here == muscles->end() ? nullptr :
                                    fibres + (here - muscles->begin());
  }



  void
  visit_points(const MixedSpace                        &space,
               const ShapeCache                        &shapes,
               const Anatomy                           &anatomy,
               const ReferenceField                    &references,
               const State                             &state,
               const std::function<void(FieldPoint &)> &visit)
  {
    const Vector relevant = space.with_ghosts(state.solution);

    ElementKernel                                kernel;
    MaterialResponse                             response;
    FieldPoint                                   point;
    std::vector<dealii::types::global_dof_index> indices(
      space.fe.n_dofs_per_cell());
    point.t = state.time;

    unsigned int cell_index = 0;
    for (const auto &cell : space.dof_handler.active_cell_iterators() |
                              dealii::IteratorFilters::LocallyOwnedCell())
      {
        const unsigned int     i      = cell_index++;
        const Region           region = Region::of(cell->material_id());
        const ShapeCache::Cell shape  = shapes.cell(i);

        point.cell      = cell;
        point.segment   = region.segment + 1;
        point.tissue    = region.tissue;
        point.is_liquid = anatomy.is_liquid(region.tissue);
        point.material  = &anatomy.tissue(region.tissue);
        point.muscles   = &anatomy.muscles_of(region.tissue);

        kernel.read(space, cell, relevant, indices);
        kernel.compute_deformation(shape);
        for (unsigned int q = 0; q < MixedSpace::n_q_points; ++q)
          {
            point.q  = q;
            point.X  = shapes.quadrature_point(i, q);
            point.dV = shape.JxW[q];
            for (unsigned int c = 0; c < dim; ++c)
              point.u[c] = kernel.displacement(shapes.node_values(), q, c);
            point.F = kernel.F[q];
            point.J = determinant(point.F);
            point.pressure_unknown =
              kernel.pressure(shapes.pressure_modes(), q);
            point.material->law().evaluate(point.F,
                                           point.pressure_unknown,
                                           references.cell(i)[q],
                                           false,
                                           response);
            point.sigma = dealii::symmetrize(
              response.P * dealii::transpose(point.F) / point.J);
            point.pressure = -trace(point.sigma) / dim;
            point.fibres   = point.muscles->empty() ?
                               nullptr :
                               references.fibres(i)[q].data();
            visit(point);
          }
      }
  }
} // namespace lumbricus
