// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/element_kernel.h>
#include <lumbricus/materials/cauchy_stress.h>
#include <lumbricus/output/field_point.h>

#include <algorithm>

namespace lumbricus
{
  const MuscleFibre *
  FieldPoint::fibre() const
  {
    if (material == nullptr)
      return nullptr;
    const auto &muscles = material->muscles();
    const auto  here    = std::find(muscles.begin(), muscles.end(), muscle);
    return here == muscles.end() ? nullptr :
                                   &reference->fibres[here - muscles.begin()];
  }



  void
  visit_points(const Body                              &body,
               const ReferenceField                    &references,
               const LiquidWeight                      &weight,
               const State                             &state,
               const std::function<void(FieldPoint &)> &visit)
  {
    const MixedSpace &space    = body.space;
    const ShapeCache &shapes   = body.shapes;
    const Vector      relevant = space.with_ghosts(state.solution);

    ElementKernel                                kernel;
    MaterialResponse                             response;
    FieldPoint                                   point;
    std::vector<dealii::types::global_dof_index> indices(
      space.fe.n_dofs_per_cell());
    point.t = state.time;

    for (const OwnedCell cell : body.owned_cells())
      {
        const ShapeCache::Cell shape = shapes.cell(cell.index);

        point.cell      = cell.iterator;
        point.segment   = cell.region.segment + 1;
        point.tissue    = cell.region.tissue;
        point.is_liquid = cell.is_liquid;
        point.material  = &cell.tissue;

        kernel.read(space, cell.iterator, relevant, indices);
        kernel.compute_deformation(shape);
        for (unsigned int q = 0; q < MixedSpace::n_q_points; ++q)
          {
            point.q  = q;
            point.X  = shapes.quadrature_point(cell.index, q);
            point.dV = shape.JxW[q];
            point.u  = kernel.displacement(shapes.node_values(q));
            point.F = kernel.F[q];
            point.J = determinant(point.F);
            point.pressure_unknown =
              kernel.pressure(shapes.pressure_modes(), q);
            point.reference = &references.cell(cell.index)[q];
            point.material->evaluate(point.F,
                                     point.pressure_unknown,
                                     *point.reference,
                                     false,
                                     response);
            point.sigma = cauchy_stress(response.P, point.F);
            if (point.is_liquid)
              point.sigma -=
                weight.excess(cell.region.segment, point.X + point.u) *
                dealii::unit_symmetric_tensor<dim, double>();
            point.pressure = -trace(point.sigma) / dim;
            visit(point);
          }
      }
  }
} // namespace lumbricus
