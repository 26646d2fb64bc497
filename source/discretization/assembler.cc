// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/assembler.h>
#include <lumbricus/discretization/same_cell.h>

#include <deal.II/grid/filtered_iterator.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lumbricus
{
  namespace
  {
    constexpr unsigned int n_nodes    = MixedSpace::n_nodes;
    constexpr unsigned int n_per_cell = CellUnknowns::n_per_cell;
  } // namespace



  Assembler::Assembler(const MixedSpace         &space,
                       const ShapeCache         &shapes,
                       const Anatomy            &anatomy,
                       const BoundaryConditions &conditions,
                       const ReferenceField     &references,
                       const Supports           &supports)
    : space(space)
    , shapes(shapes)
    , anatomy(anatomy)
    , conditions(conditions)
    , references(references)
    , supports(supports)
    , unknowns(space)
    , linearisation(space, shapes, unknowns)
    , kernel(std::make_unique<ElementKernel>())
    , face_values(space.mapping,
                  space.fe,
                  space.face_quadrature,
                  dealii::update_values | dealii::update_gradients |
                    dealii::update_JxW_values | dealii::update_normal_vectors |
                    dealii::update_quadrature_points)
  {}



  void
  Assembler::reinit()
  {
    unknowns.reinit(supports.constraints());
    linearisation.reinit();
    linearisation.symmetric = conditions.symmetric();
    for (CellVector *x : {&u, &sum, &rhs})
      unknowns.reinit_vector(*x);
  }



  Assembler::Report
  Assembler::residual(const Vector &solution, const double t, Vector &r)
  {
    const Report report = assemble(solution, t, false);
    std::copy(sum.begin(), sum.end(), r.begin());
    return report;
  }



  Assembler::Report
  Assembler::linearise(const Vector &solution, const double t)
  {
    unknowns.update_inhomogeneities(supports.constraints());
    const Report report = assemble(solution, t, true);
    rhs.copy_locally_owned_data_from(sum);
    rhs *= -1.;
    return report;
  }



  const Tangent &
  Assembler::tangent() const
  {
    return linearisation;
  }



  const CellVector &
  Assembler::right_hand_side() const
  {
    return rhs;
  }



  Assembler::Report
  Assembler::assemble(const Vector &solution,
                      const double  t,
                      const bool    with_tangent)
  {
    std::copy(solution.begin(), solution.end(), u.begin());
    u.update_ghost_values();
    sum = 0.;
    if (with_tangent)
      linearisation.clear_surface_matrices();

    Report report;
    report.min_J              = std::numeric_limits<double>::max();
    double       force_square = 0.;
    unsigned int cell_index   = 0;
    double       values[n_per_cell], change[n_per_cell];
    for (const auto &cell : space.dof_handler.active_cell_iterators() |
                              dealii::IteratorFilters::LocallyOwnedCell())
      {
        const unsigned int i      = cell_index++;
        const Region       region = Region::of(cell->material_id());
        const MaterialLaw &law    = anatomy.tissue(region.tissue).law();

        unknowns.read(i, u, values);
        kernel->set(values);
        const double min_J =
          kernel->evaluate(shapes.cell(i),
                           shapes.pressure_modes(),
                           law,
                           references.cell(i),
                           with_tangent ? &linearisation.cell(i) : nullptr);
        if (!(min_J >= report.min_J))
          {
            report.min_J         = min_J;
            report.min_J_segment = region.segment;
          }
        if (!(min_J > 0.))
          continue;

        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int n = 0; n < n_nodes; ++n)
            force_square += kernel->force[c][n] * kernel->force[c][n];
        kernel->get_residual(values);
        if (cell->at_boundary())
          add_surface_terms(cell, i, t, with_tangent, values);

        if (with_tangent)
          {
            // What is prescribed and still missing pulls at the free unknowns.
            linearisation.shear_modulus[i] = law.shear_modulus();
            double missing[n_per_cell];
            if (unknowns.read_inhomogeneity(i, missing))
              {
                linearisation.vmult_cell(i, missing, change);
                for (unsigned int k = 0; k < n_per_cell; ++k)
                  values[k] += change[k];
              }
          }
        unknowns.add(i, values, sum);
      }
    sum.compress(dealii::VectorOperation::add);

    const auto comm = space.communicator();
    report.force_level =
      std::sqrt(dealii::Utilities::MPI::sum(force_square, comm));
    const auto least = dealii::Utilities::MPI::min_max_avg(report.min_J, comm);
    report.min_J_segment =
      dealii::Utilities::MPI::broadcast(comm,
                                        report.min_J_segment,
                                        least.min_index);
    report.min_J = least.min;
    return report;
  }



  void
  Assembler::add_surface_terms(
    const dealii::DoFHandler<dim>::active_cell_iterator &cell,
    const unsigned int                                   i,
    const double                                         t,
    const bool                                           with_tangent,
    double                                              *residual)
  {
    for (const auto &face : cell->face_iterators())
      {
        if (!face->at_boundary())
          continue;
        const auto acting = conditions.on_boundary(face->boundary_id());
        bool       any    = false;
        for (const BoundaryCondition *condition : acting)
          any = any || condition->acts_on_surface();
        if (!any)
          continue;

        face_values.reinit(mesh_cell(cell), face);
        for (const unsigned int q : face_values.quadrature_point_indices())
          {
            SurfacePoint point;
            point.X = face_values.quadrature_point(q);
            point.N = face_values.normal_vector(q);
            point.t = t;
            point.F = dealii::unit_symmetric_tensor<dim, double>();

            dealii::Tensor<1, dim> gradients[n_nodes];
            double                 values[n_nodes];
            for (unsigned int n = 0; n < n_nodes; ++n)
              {
                const unsigned int dof = space.displacement_dof[0][n];
                gradients[n]           = face_values.shape_grad(dof, q);
                values[n]              = face_values.shape_value(dof, q);
                for (unsigned int c = 0; c < dim; ++c)
                  {
                    point.u[c] += kernel->u[c][n] * values[n];
                    for (unsigned int J = 0; J < dim; ++J)
                      point.F[c][J] += kernel->u[c][n] * gradients[n][J];
                  }
              }

            for (const BoundaryCondition *condition : acting)
              {
                if (!condition->acts_on_surface())
                  continue;
                SurfaceResponse response;
                condition->surface(point, response);
                const double w = face_values.JxW(q);
                for (unsigned int n = 0; n < n_nodes; ++n)
                  for (unsigned int c = 0; c < dim; ++c)
                    residual[CellUnknowns::displacement(c, n)] -=
                      w * values[n] * response.T[c];
                if (!with_tangent || !response.depends_on_shape())
                  continue;
                auto &matrix = linearisation.surface_matrix(i);
                for (unsigned int c = 0; c < dim; ++c)
                  for (unsigned int k = 0; k < dim; ++k)
                    for (unsigned int m = 0; m < n_nodes; ++m)
                      {
                        const double dT = response.dT_du[c][k] * values[m] +
                                          response.dT_dF[c][k] * gradients[m];
                        for (unsigned int n = 0; n < n_nodes; ++n)
                          matrix[CellUnknowns::displacement(c, n) * n_per_cell +
                                 CellUnknowns::displacement(k, m)] -=
                            w * values[n] * dT;
                      }
              }
          }
      }
  }
} // namespace lumbricus
