// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/assembler.h>
#include <lumbricus/discretization/same_cell.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/grid/filtered_iterator.h>
#include <deal.II/lac/trilinos_sparsity_pattern.h>

#include <cmath>

namespace lumbricus
{
  namespace
  {
    constexpr unsigned int n_nodes = MixedSpace::n_nodes;
    constexpr unsigned int n_modes = MixedSpace::n_pressure_modes;
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
    , kernel(std::make_unique<ElementKernel>())
    , cell_matrix(space.fe.n_dofs_per_cell())
    , cell_vector(space.fe.n_dofs_per_cell())
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
    // The rows this rank writes to: its own, those of its ghosts, and what
    // these hang on.
    dealii::IndexSet writable = space.locally_relevant;
    for (const auto &line : supports.constraints().get_lines())
      for (const auto &[index, weight] : line.entries)
        writable.add_index(index);
    writable.compress();

    dealii::TrilinosWrappers::SparsityPattern pattern(space.locally_owned,
                                                      space.locally_owned,
                                                      writable,
                                                      space.communicator());
    dealii::DoFTools::make_sparsity_pattern(
      space.dof_handler,
      pattern,
      supports.constraints(),
      false,
      dealii::Utilities::MPI::this_mpi_process(space.communicator()));
    pattern.compress();
    tangent.reinit(pattern);
    rhs.reinit(space.locally_owned, space.communicator());
    relevant_solution.reinit(space.locally_owned,
                             space.locally_relevant,
                             space.communicator());
  }



  Assembler::Report
  Assembler::residual(const Vector &solution, const double t, Vector &r)
  {
    return assemble(solution, t, false, r);
  }



  Assembler::Report
  Assembler::linearise(const Vector &solution, const double t)
  {
    return assemble(solution, t, true, rhs);
  }



  bool
  Assembler::symmetric() const
  {
    return conditions.symmetric();
  }



  const Matrix &
  Assembler::matrix() const
  {
    return tangent;
  }



  const Vector &
  Assembler::right_hand_side() const
  {
    return rhs;
  }



  Assembler::Report
  Assembler::assemble(const Vector &solution,
                      const double  t,
                      const bool    with_tangent,
                      Vector       &vector)
  {
    relevant_solution = solution;
    vector            = 0.;
    if (with_tangent)
      tangent = 0.;

    Report report;
    report.min_J            = std::numeric_limits<double>::max();
    double       sum        = 0.;
    unsigned int cell_index = 0;

    std::vector<dealii::types::global_dof_index> indices(
      space.fe.n_dofs_per_cell());
    for (const auto &cell : space.dof_handler.active_cell_iterators() |
                              dealii::IteratorFilters::LocallyOwnedCell())
      {
        const unsigned int i      = cell_index++;
        const Region       region = Region::of(cell->material_id());

        kernel->read(space, cell, relevant_solution, indices);
        const double min_J =
          kernel->evaluate(shapes.cell(i),
                           shapes.pressure_modes(),
                           anatomy.tissue(region.tissue).law(),
                           references.cell(i),
                           with_tangent);
        if (!(min_J >= report.min_J))
          {
            report.min_J         = min_J;
            report.min_J_segment = region.segment;
          }
        if (!(min_J > 0.))
          continue;

        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int n = 0; n < n_nodes; ++n)
            sum += kernel->force[c][n] * kernel->force[c][n];
        gather_blocks(with_tangent);
        if (cell->at_boundary())
          add_surface_terms(cell, t, with_tangent);

        if (with_tangent)
          {
            cell_vector *= -1.;
            supports.constraints().distribute_local_to_global(
              cell_matrix, cell_vector, indices, tangent, vector);
          }
        else
          supports.constraints().distribute_local_to_global(cell_vector,
                                                            indices,
                                                            vector);
      }

    vector.compress(dealii::VectorOperation::add);
    if (with_tangent)
      tangent.compress(dealii::VectorOperation::add);

    const auto comm    = space.communicator();
    report.force_level = std::sqrt(dealii::Utilities::MPI::sum(sum, comm));
    const auto least = dealii::Utilities::MPI::min_max_avg(report.min_J, comm);
    report.min_J_segment =
      dealii::Utilities::MPI::broadcast(comm,
                                        report.min_J_segment,
                                        least.min_index);
    report.min_J = least.min;
    return report;
  }



  void
  Assembler::gather_blocks(const bool with_tangent)
  {
    const auto &u = space.displacement_dof;
    const auto &p = space.pressure_dof;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int n = 0; n < n_nodes; ++n)
        cell_vector(u[i][n]) = kernel->force[i][n];
    for (unsigned int m = 0; m < n_modes; ++m)
      cell_vector(p[m]) = kernel->volume[m];

    if (!with_tangent)
      return;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int k = 0; k < dim; ++k)
        for (unsigned int n = 0; n < n_nodes; ++n)
          for (unsigned int m = 0; m < n_nodes; ++m)
            cell_matrix(u[i][n], u[k][m]) = kernel->K_uu(i, k, n, m);
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int n = 0; n < n_nodes; ++n)
        for (unsigned int m = 0; m < n_modes; ++m)
          {
            cell_matrix(u[i][n], p[m]) = kernel->K_up[i][n][m];
            cell_matrix(p[m], u[i][n]) = kernel->K_up[i][n][m];
          }
    for (unsigned int n = 0; n < n_modes; ++n)
      for (unsigned int m = 0; m < n_modes; ++m)
        cell_matrix(p[n], p[m]) = kernel->K_pp[n][m];
  }



  void
  Assembler::add_surface_terms(
    const dealii::DoFHandler<dim>::active_cell_iterator &cell,
    const double                                         t,
    const bool                                           with_tangent)
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
                for (unsigned int i = 0; i < dim; ++i)
                  {
                    point.u[i] += kernel->u[i][n] * values[n];
                    for (unsigned int J = 0; J < dim; ++J)
                      point.F[i][J] += kernel->u[i][n] * gradients[n][J];
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
                  for (unsigned int i = 0; i < dim; ++i)
                    cell_vector(space.displacement_dof[i][n]) -=
                      w * values[n] * response.T[i];
                if (!with_tangent)
                  continue;
                for (unsigned int i = 0; i < dim; ++i)
                  for (unsigned int k = 0; k < dim; ++k)
                    for (unsigned int m = 0; m < n_nodes; ++m)
                      {
                        const double dT = response.dT_du[i][k] * values[m] +
                                          response.dT_dF[i][k] * gradients[m];
                        for (unsigned int n = 0; n < n_nodes; ++n)
                          cell_matrix(space.displacement_dof[i][n],
                                      space.displacement_dof[k][m]) -=
                            w * values[n] * dT;
                      }
              }
          }
      }
  }
} // namespace lumbricus
