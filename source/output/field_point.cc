// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/element_kernel.h>
#include <lumbricus/materials/cauchy_stress.h>
#include <lumbricus/output/field_point.h>

#include <deal.II/grid/filtered_iterator.h>

#include <algorithm>

namespace lumbricus
{
  const MuscleFibre *
  FieldPoint::fibre() const
  {
    const auto &muscles = material->muscles();
    const auto  here    = std::find(muscles.begin(), muscles.end(), muscle);
    return here == muscles.end() ? nullptr :
                                   &reference->fibres[here - muscles.begin()];
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
            point.reference = &references.cell(i)[q];
            point.material->evaluate(point.F,
                                     point.pressure_unknown,
                                     *point.reference,
                                     false,
                                     response);
            point.sigma    = cauchy_stress(response.P, point.F);
            point.pressure = -trace(point.sigma) / dim;
            visit(point);
          }
      }
  }
} // namespace lumbricus
