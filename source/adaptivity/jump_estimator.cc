// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/adaptivity/jump_estimator.h>
#include <lumbricus/discretization/same_cell.h>

#include <deal.II/fe/fe.h>
#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_update_flags.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/meshworker/assemble_flags.h>
#include <deal.II/meshworker/mesh_loop.h>

#include <cmath>

namespace lumbricus
{
  namespace
  {
    using CellIterator = dealii::Triangulation<dim>::active_cell_iterator;

    const std::string displacement_name = "displacement";
    const std::string stress_name       = "cauchy_stress";

    unsigned int
    tissue(const CellIterator &cell)
    {
      return Region::of(cell->material_id()).tissue;
    }



    // The flux on a cell, from the fields' values at its nodes.
    class FluxOnCell
    {
    public:
      FluxOnCell(const JumpEstimator &estimator, const CellFields &fields)
        : estimator(estimator)
        , fields(fields)
        , fe(fields.dof_handler().get_fe())
        , displacement(fields.components(displacement_name))
        , stress(fields.components(stress_name))
        , indices(fe.n_dofs_per_cell())
      {}

      void
      reinit(const CellIterator &cell)
      {
        same_cell(cell, fields.dof_handler())->get_dof_indices(indices);
        for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
          {
            for (unsigned int c = 0; c < dim; ++c)
              u[n][c] = value(displacement[c], n);
            for (unsigned int i = 0; i < dim; ++i)
              for (unsigned int j = 0; j < dim; ++j)
                sigma[n][i][j] = value(stress[dim * i + j], n);
          }
        const Anatomy &anatomy = fields.body.anatomy;
        mu = anatomy.tissue(tissue(cell)).shear_modulus();
      }

      // At a quadrature point of scalar shape functions of the fields.
      dealii::Tensor<2, dim>
      operator()(const dealii::FEValuesBase<dim> &shape,
                 const unsigned int               q) const
      {
        dealii::Tensor<2, dim> F = dealii::unit_symmetric_tensor<dim>();
        dealii::Tensor<2, dim> sigma_here;
        for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
          {
            F += outer_product(u[n], shape.shape_grad(n, q));
            sigma_here += shape.shape_value(n, q) * sigma[n];
          }
        const dealii::Tensor<2, dim> P =
          determinant(F) * sigma_here * transpose(invert(F));
        return estimator.flux(mu, F, P);
      }

    private:
      double
      value(const unsigned int component, const unsigned int node) const
      {
        return fields.values()(
          indices[fe.component_to_system_index(component, node)]);
      }

      const JumpEstimator              &estimator;
      const CellFields                 &fields;
      const dealii::FiniteElement<dim> &fe;

      // Their components.
      const std::vector<unsigned int> displacement;
      const std::vector<unsigned int> stress;

      std::vector<dealii::types::global_dof_index>            indices;
      std::array<dealii::Tensor<1, dim>, MixedSpace::n_nodes> u;
      std::array<dealii::Tensor<2, dim>, MixedSpace::n_nodes> sigma;
      double                                                  mu = 0.;
    };



    dealii::UpdateFlags
    update_flags()
    {
      return dealii::update_values | dealii::update_gradients |
             dealii::update_normal_vectors | dealii::update_JxW_values;
    }



    // Shape functions of the fields on a face, or on a part of it.
    class FaceShape
    {
    public:
      FaceShape(const MixedSpace                 &space,
                const dealii::FiniteElement<dim> &scalar)
        : whole(space.mapping, scalar, space.face_quadrature, update_flags())
        , part(space.mapping, scalar, space.face_quadrature, update_flags())
      {}

      const dealii::FEFaceValuesBase<dim> &
      reinit(const CellIterator &cell,
             const unsigned int  face,
             const unsigned int  subface)
      {
        if (subface == dealii::numbers::invalid_unsigned_int)
          {
            whole.reinit(mesh_cell(cell), face);
            return whole;
          }
        part.reinit(mesh_cell(cell), face, subface);
        return part;
      }

    private:
      dealii::FEFaceValues<dim>    whole;
      dealii::FESubfaceValues<dim> part;
    };



    // One side of a face.
    struct Side
    {
      FaceShape  shape;
      FluxOnCell flux;
    };



    struct Scratch
    {
      Scratch(const MixedSpace                 &space,
              const dealii::FiniteElement<dim> &scalar,
              const FluxOnCell                 &flux)
        : space(space)
        , scalar(scalar)
        , here{FaceShape(space, scalar), flux}
        , there{FaceShape(space, scalar), flux}
      {}

      // FEFaceValues cannot be copied.
      Scratch(const Scratch &other)
        : Scratch(other.space, other.scalar, other.here.flux)
      {}

      const MixedSpace                 &space;
      const dealii::FiniteElement<dim> &scalar;
      Side                              here, there;
    };



    // What the faces of a cell add to their two cells.
    struct FaceTerms
    {
      std::vector<std::pair<CellIterator, double>> terms;
    };



    // int |G|^2 dV over the locally owned cells.
    double
    norm_square(FluxOnCell                        flux,
                const MixedSpace                 &space,
                const dealii::FiniteElement<dim> &scalar)
    {
      dealii::FEValues<dim> shape(space.mapping,
                                  scalar,
                                  space.quadrature,
                                  dealii::update_values |
                                    dealii::update_gradients |
                                    dealii::update_JxW_values);
      double                sum = 0.;
      for (const auto &cell : space.owned_cells())
        {
          shape.reinit(mesh_cell(cell));
          flux.reinit(cell);
          for (const unsigned int q : shape.quadrature_point_indices())
            sum += flux(shape, q).norm_square() * shape.JxW(q);
        }
      return sum;
    }
  } // namespace



  ErrorEstimate
  JumpEstimator::estimate(EstimatedState &state) const
  {
    const CellFields         &fields =
      state.fields({displacement_name, stress_name});
    const MixedSpace         &space = fields.body.space;
    const dealii::FE_DGQ<dim> scalar(MixedSpace::degree);
    const FluxOnCell          flux_on_cell(*this, fields);

    const bool between_tissues = continuous_between_tissues();

    const auto face_term = [&](const CellIterator &cell,
                               const unsigned int  face,
                               const unsigned int  subface,
                               const CellIterator &neighbor,
                               const unsigned int  neighbor_face,
                               const unsigned int  neighbor_subface,
                               Scratch            &scratch,
                               FaceTerms          &result) {
      if (!between_tissues && tissue(cell) != tissue(neighbor))
        return;
      const auto &here = scratch.here.shape.reinit(cell, face, subface);
      const auto &there =
        scratch.there.shape.reinit(neighbor, neighbor_face, neighbor_subface);
      scratch.here.flux.reinit(cell);
      scratch.there.flux.reinit(neighbor);

      double integral = 0.;
      for (const unsigned int q : here.quadrature_point_indices())
        integral +=
          ((scratch.here.flux(here, q) - scratch.there.flux(there, q)) *
           here.normal_vector(q))
            .norm_square() *
          here.JxW(q);
      // The face of the finer cell is the one integrated over.
      const double h    = cell->face(face)->diameter();
      const double term = 0.5 * h / (2. * MixedSpace::degree) * integral;
      result.terms.emplace_back(cell, term);
      result.terms.emplace_back(neighbor, term);
    };

    std::vector<double> of_active_cell(space.triangulation.n_active_cells());
    dealii::MeshWorker::mesh_loop(
      space.triangulation.active_cell_iterators(),
      std::function<void(const CellIterator &, Scratch &, FaceTerms &)>(),
      [&](const FaceTerms &result) {
        for (const auto &[cell, term] : result.terms)
          of_active_cell[cell->active_cell_index()] += term;
      },
      Scratch(space, scalar, flux_on_cell),
      FaceTerms(),
      dealii::MeshWorker::assemble_own_interior_faces_once |
        dealii::MeshWorker::assemble_ghost_faces_both,
      std::function<void(
        const CellIterator &, const unsigned int, Scratch &, FaceTerms &)>(),
      std::function<void(const CellIterator &,
                         const unsigned int,
                         const unsigned int,
                         const CellIterator &,
                         const unsigned int,
                         const unsigned int,
                         Scratch &,
                         FaceTerms &)>(face_term));

    ErrorEstimate estimate;
    double        sums[2] = {0., norm_square(flux_on_cell, space, scalar)};
    for (const auto &cell : space.owned_cells())
      {
        estimate.contributions.push_back(
          of_active_cell[cell->active_cell_index()]);
        sums[0] += estimate.contributions.back();
      }
    dealii::Utilities::MPI::sum(sums, space.communicator(), sums);
    estimate.relative = sums[1] > 0. ? std::sqrt(sums[0] / sums[1]) : 0.;
    return estimate;
  }
} // namespace lumbricus
