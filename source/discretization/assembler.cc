// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/area_derivative.h>
#include <lumbricus/discretization/assembler.h>
#include <lumbricus/discretization/cell_sizes.h>

#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace lumbricus
{
  namespace
  {
    using cell_sizes::n_nodes;
    using cell_sizes::n_per_cell;



    // From the residual of a cell, what a force f per area or volume does at a
    // point where the nodes have the values N_n and which has the weight w.
    void
    subtract_force(const double                  w,
                   const double                 *N,
                   const dealii::Tensor<1, dim> &f,
                   double                       *residual)
    {
      for (unsigned int n = 0; n < n_nodes; ++n)
        for (unsigned int c = 0; c < dim; ++c)
          residual[CellUnknowns::displacement(c, n)] -= w * N[n] * f[c];
    }



    // From the matrix of a cell, what that hangs on the displacements:
    // df(c, k, m) is the derivative of f_c by component k at node m. All but the
    // nodes in rows have N_n = 0, and only those in columns have a derivative.
    template <typename Rows, typename Columns, typename Derivative>
    void
    subtract_derivative(const double         w,
                        const double        *N,
                        const Rows          &rows,
                        const Columns       &columns,
                        const Derivative    &df,
                        std::vector<double> &matrix)
    {
      for (const unsigned int m : columns)
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int k = 0; k < dim; ++k)
            {
              const double value = w * df(c, k, m);
              for (const unsigned int n : rows)
                matrix[CellUnknowns::displacement(c, n) * n_per_cell +
                       CellUnknowns::displacement(k, m)] -= N[n] * value;
            }
    }



    // The numbers of all nodes of a cell.
    std::array<unsigned int, n_nodes>
    every_node()
    {
      std::array<unsigned int, n_nodes> all;
      std::iota(all.begin(), all.end(), 0u);
      return all;
    }

    const std::array<unsigned int, n_nodes> all_nodes = every_node();
  } // namespace



  Assembler::Assembler(const Body           &body,
                       SurfaceTerms         &terms,
                       const VolumeTerms    &volume_terms,
                       LiquidWeight         &liquid_weight,
                       const ReferenceField &references,
                       const Supports       &supports)
    : body(body)
    , terms(terms)
    , volume_terms(volume_terms)
    , liquid_weight(liquid_weight)
    , references(references)
    , supports(supports)
    , unknowns(body.space)
    , linearisation(body.space, body.shapes, unknowns)
    , kernel(std::make_unique<ElementKernel>())
    , surface(body.space)
  {}



  void
  Assembler::reinit()
  {
    unknowns.reinit(supports.constraints());
    linearisation.reinit();
    rounding.reinit(body.shapes);
    linearisation.symmetric =
      terms.symmetric() && volume_terms.symmetric();
    for (Vector *x : {&u, &rhs})
      unknowns.reinit_vector(*x);
  }



  bool
  Assembler::update_constraints()
  {
    return unknowns.update_weights(supports.constraints());
  }



  Assembler::Report
  Assembler::residual(const Vector &solution, const LoadTime &t, Vector &r)
  {
    const Report report = assemble(solution, t, false, r);
    n_stuck             = report.n_sticking;
    return report;
  }



  Assembler::Report
  Assembler::linearise(const Vector &solution, const LoadTime &t)
  {
    unknowns.update_inhomogeneities(supports.constraints());
    const Report report = assemble(solution, t, true, rhs);
    rhs *= -1.;
    return report;
  }



  const Tangent &
  Assembler::tangent() const
  {
    return linearisation;
  }



  Tangent &
  Assembler::tangent()
  {
    return linearisation;
  }



  const Vector &
  Assembler::right_hand_side() const
  {
    return rhs;
  }



  Assembler::Report
  Assembler::assemble(const Vector   &solution,
                      const LoadTime &t,
                      const bool      with_tangent,
                      Vector         &sum)
  {
    u.copy_locally_owned_data_from(solution);
    u.update_ghost_values();
    unknowns.reinit_vector(sum);
    if (with_tangent)
      linearisation.clear_surface_matrices();

    rounding.clear();
    n_sticking = 0.;
    Report report;
    report.min_J              = std::numeric_limits<double>::max();
    double force_square = 0.;
    double values[n_per_cell], change[n_per_cell];
    for (const OwnedCell cell : body.owned_cells())
      {
        const unsigned int i  = cell.index;
        const double       mu = cell.tissue.shear_modulus();

        unknowns.read(i, u, values);
        kernel->set(values);
        const double min_J =
          kernel->evaluate(body.shapes.cell(i),
                           body.shapes.pressure_modes(),
                           cell.tissue,
                           references.cell(i),
                           with_tangent ? &linearisation.cell(i) : nullptr);
        if (!(min_J >= report.min_J))
          {
            report.min_J         = min_J;
            report.min_J_segment = cell.region.segment;
          }
        if (!(min_J > 0.))
          continue;

        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int n = 0; n < n_nodes; ++n)
            force_square += kernel->force[c][n] * kernel->force[c][n];
        rounding.add(i,
                     *kernel,
                     body.shapes.pressure_modes(),
                     mu,
                     references.cell(i));
        kernel->get_residual(values);
        if (cell.iterator->at_boundary())
          add_surface_terms(cell, t, with_tangent, values);
        if (volume_terms.act_in(cell))
          add_volume_terms(cell, t, with_tangent, values);
        if (liquid_weight.acts_on(cell))
          add_liquid_weight(cell, with_tangent, values);

        if (with_tangent)
          {
            // What is prescribed and still missing pulls at the free unknowns.
            linearisation.shear_modulus[i] = mu;
            add_interface_tangent(cell);
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

    const auto comm = body.space.communicator();
    double     sums[] = {force_square,
                         rounding.force_square(),
                         rounding.volume(),
                         n_sticking};
    dealii::Utilities::MPI::sum(sums, comm, sums);
    report.force_level     = std::sqrt(sums[0]);
    report.force_rounding  = std::sqrt(sums[1]);
    report.volume_rounding = sums[2];
    report.n_sticking      = sums[3];
    const auto least = dealii::Utilities::MPI::min_max_avg(report.min_J, comm);
    report.min_J_segment =
      dealii::Utilities::MPI::broadcast(comm,
                                        report.min_J_segment,
                                        least.min_index);
    report.min_J = least.min;
    return report;
  }



  void
  Assembler::add_surface_terms(const OwnedCell &cell,
                               const LoadTime  &t,
                               const bool       with_tangent,
                               double          *residual)
  {
    // Where all terms together are symmetric, each cell takes its symmetric part.
    std::vector<double> matrix;
    const bool          apart = linearisation.symmetric;
    terms.visit(cell,
                kernel->u,
                t,
                [&](const unsigned int /*condition*/,
                    const SurfaceResponse &response) {
                  const SurfaceKernel &point = terms.point();
                  subtract_force(point.JxW, point.values, response.T, residual);
                  n_sticking += response.sticks;
                  if (!with_tangent || !response.depends_on_shape())
                    return;
                  if (apart)
                    matrix.resize(n_per_cell * n_per_cell);
                  std::vector<double> &to =
                    apart ? matrix : linearisation.surface_matrix(cell.index);
                  const dealii::Tensor<2, dim> dT_du =
                    n_stuck > 0. ? response.dT_du :
                                   response.dT_du + response.stabilisation;
                  subtract_derivative(
                    point.JxW,
                    point.values,
                    point.face_nodes,
                    point.face_nodes,
                    [&](const unsigned int c,
                        const unsigned int k,
                        const unsigned int m) {
                      return dT_du[c][k] * point.values[m];
                    },
                    to);
                  // Gradients hang on all nodes.
                  if (response.dT_dF.norm_square() > 0.)
                    subtract_derivative(
                      point.JxW,
                      point.values,
                      point.face_nodes,
                      all_nodes,
                      [&](const unsigned int c,
                          const unsigned int k,
                          const unsigned int m) {
                        return response.dT_dF[c][k] * point.gradients[m];
                      },
                      to);
                });
    if (matrix.empty())
      return;
    std::vector<double> &all = linearisation.surface_matrix(cell.index);
    for (unsigned int i = 0; i < n_per_cell; ++i)
      for (unsigned int j = 0; j < n_per_cell; ++j)
        all[i * n_per_cell + j] +=
          0.5 * (matrix[i * n_per_cell + j] + matrix[j * n_per_cell + i]);
  }



  void
  Assembler::add_volume_terms(const OwnedCell &cell,
                              const LoadTime  &t,
                              const bool       with_tangent,
                              double          *residual)
  {
    volume_terms.visit(
      cell,
      kernel->u,
      t,
      [&](const unsigned int /*force*/,
          const VolumeTerms::Point &point,
          const VolumeResponse     &response) {
        subtract_force(point.JxW, point.values, response.b, residual);
        if (!with_tangent || !response.depends_on_place())
          return;
        subtract_derivative(
          point.JxW,
          point.values,
          all_nodes,
          all_nodes,
          [&](const unsigned int c, const unsigned int k, const unsigned int m) {
            return response.db_du[c][k] * point.values[m];
          },
          linearisation.surface_matrix(cell.index));
      });
  }



  void
  Assembler::add_liquid_weight(const OwnedCell &cell,
                               const bool       with_tangent,
                               double          *residual)
  {
    liquid_weight.visit(
      cell,
      kernel->u,
      [&](const unsigned int /*force*/,
          const dealii::Tensor<1, dim> &gravity,
          const double                  q,
          const double                  sign) {
        const SurfaceKernel &point = liquid_weight.point();
        const auto           a = sign * (cofactor(point.F) * point.N);
        subtract_force(point.JxW, point.values, q * a, residual);
        if (!with_tangent)
          return;
        // Both parts are symmetric over the closed surface, and taken so face by
        // face.
        auto &matrix = linearisation.surface_matrix(cell.index);
        add_area_derivative(point, -sign * q, matrix);
        subtract_derivative(
          0.5 * point.JxW,
          point.values,
          point.face_nodes,
          point.face_nodes,
          [&](const unsigned int c, const unsigned int k, const unsigned int m) {
            return point.values[m] * (a[k] * gravity[c] + a[c] * gravity[k]);
          },
          matrix);
      });
  }



  void
  Assembler::add_interface_tangent(const OwnedCell &cell)
  {
    for (const unsigned int f : cell.iterator->face_indices())
      {
        if (!supports.is_sliding_face(cell.iterator, f))
          continue;
        surface.reinit(cell.iterator, f);
        auto &matrix = linearisation.surface_matrix(cell.index);
        for (unsigned int q = 0; q < surface.n_points(); ++q)
          {
            surface.set(q, kernel->u);
            add_area_derivative(surface,
                                -surface.pressure(kernel->p),
                                matrix);
          }
      }
  }
} // namespace lumbricus
