// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/cell_fields.h>
#include <lumbricus/discretization/cell_sizes.h>
#include <lumbricus/discretization/element_kernel.h>
#include <lumbricus/discretization/same_cell.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_tools.h>
#include <deal.II/grid/filtered_iterator.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace lumbricus
{
  namespace Interpretation = dealii::DataComponentInterpretation;

  namespace
  {
    using cell_sizes::n_q;

    // The values of all fields at one quadrature point, in order.
    class PointValues
    {
    public:
      explicit PointValues(std::vector<double> &values)
        : next(values.begin())
      {}

      void
      add(const double value)
      {
        *next++ = value;
      }

      template <int rank>
      void
      add(const dealii::Tensor<rank, dim> &value)
      {
        for (unsigned int i = 0; i < dim; ++i)
          add(value[i]);
      }

    private:
      std::vector<double>::iterator next;
    };
  } // namespace



  CellFields::CellFields(const MixedSpace     &space,
                         const ShapeCache     &shapes,
                         const Anatomy        &anatomy,
                         const ReferenceField &references)
    : space(space)
    , shapes(shapes)
    , anatomy(anatomy)
    , references(references)
    , fields_dof_handler(space.triangulation)
  {
    add("displacement", Interpretation::component_is_part_of_vector, dim);
    add("pressure", Interpretation::component_is_scalar, 1);
    add("cauchy_stress",
        Interpretation::component_is_part_of_tensor,
        dim * dim);
    add("J", Interpretation::component_is_scalar, 1);
    add("hydrostatic_divergence", Interpretation::component_is_scalar, 1);
    for (unsigned int i = 0; i < anatomy.n_muscles(); ++i)
      {
        const std::string name = anatomy.muscle(i).field_name();
        add("fibre_" + name, Interpretation::component_is_part_of_vector, dim);
        add("active_stretch_" + name, Interpretation::component_is_scalar, 1);
      }

    add("pressure_unknown", Interpretation::component_is_scalar, 1);

    const dealii::FE_DGQ<dim> scalar(MixedSpace::degree);
    fe =
      std::make_unique<dealii::FESystem<dim>>(scalar, component_names.size());
    projection.reinit(scalar.n_dofs_per_cell(), n_q);
    dealii::FETools::compute_projection_from_quadrature_points_matrix(
      scalar, space.quadrature, space.quadrature, projection);
  }



  void
  CellFields::add(const std::string                                &name,
                  const Interpretation::DataComponentInterpretation kind,
                  const unsigned int                                n)
  {
    component_names.insert(component_names.end(), n, name);
    component_interpretations.insert(component_interpretations.end(), n, kind);
  }



  void
  CellFields::reinit()
  {
    fields_dof_handler.distribute_dofs(*fe);
    field_values.reinit(fields_dof_handler.locally_owned_dofs(),
                        dealii::DoFTools::extract_locally_relevant_dofs(
                          fields_dof_handler),
                        space.communicator());
  }



  void
  CellFields::update(const Vector &solution)
  {
    const Vector relevant = space.with_ghosts(solution);
    Vector owned(fields_dof_handler.locally_owned_dofs(), space.communicator());

    ElementKernel                                kernel;
    MaterialResponse                             response;
    std::vector<dealii::types::global_dof_index> indices(
      space.fe.n_dofs_per_cell());
    std::vector<dealii::types::global_dof_index> field_indices(
      fe->n_dofs_per_cell());
    std::vector<std::vector<double>> values(
      n_q, std::vector<double>(component_names.size()));

    unsigned int cell_index = 0;
    for (const auto &cell : space.dof_handler.active_cell_iterators() |
                              dealii::IteratorFilters::LocallyOwnedCell())
      {
        const unsigned int i       = cell_index++;
        const unsigned int tissue  = Region::of(cell->material_id()).tissue;
        const bool         liquid  = anatomy.is_liquid(tissue);
        const auto        &law     = anatomy.tissue(tissue).law();
        const auto        &muscles = anatomy.muscles_of(tissue);

        kernel.read(space, cell, relevant, indices);
        kernel.compute_deformation(shapes.cell(i));
        for (unsigned int q = 0; q < n_q; ++q)
          {
            const auto  &F = kernel.F[q];
            const double J = determinant(F);
            const double pressure_unknown =
              kernel.pressure(shapes.pressure_modes(), q);
            law.evaluate(
              F, pressure_unknown, references.cell(i)[q], false, response);
            const auto sigma =
              dealii::symmetrize(response.P * dealii::transpose(F) / J);
            const double p = -trace(sigma) / dim;

            PointValues point(values[q]);
            for (unsigned int c = 0; c < dim; ++c)
              point.add(kernel.displacement(shapes.node_values(), q, c));
            point.add(p);
            point.add(dealii::Tensor<2, dim>(sigma));
            point.add(J);
            point.add(liquid ? dealii::deviator(sigma).norm() /
                                 std::max(std::abs(p),
                                          std::numeric_limits<double>::min()) :
                               0.);
            for (unsigned int m = 0; m < anatomy.n_muscles(); ++m)
              {
                const auto here =
                  std::find(muscles.begin(), muscles.end(), &anatomy.muscle(m));
                if (here == muscles.end())
                  {
                    point.add(dealii::Tensor<1, dim>());
                    point.add(1.);
                    continue;
                  }
                const ActiveFibre &fibre =
                  references.fibres(i)[q][here - muscles.begin()];
                const dealii::Tensor<1, dim> f = F * fibre.f;
                point.add(f / f.norm());
                point.add(fibre.lambda);
              }
            point.add(pressure_unknown);
          }

        same_cell(cell, fields_dof_handler)->get_dof_indices(field_indices);
        for (unsigned int k = 0; k < fe->n_dofs_per_cell(); ++k)
          {
            const auto [component, node] = fe->system_to_component_index(k);
            double value                 = 0.;
            for (unsigned int q = 0; q < n_q; ++q)
              value += projection(node, q) * values[q][component];
            owned(field_indices[k]) = value;
          }
      }
    owned.compress(dealii::VectorOperation::insert);
    field_values = owned;
  }



  const std::vector<std::string> &
  CellFields::names() const
  {
    return component_names;
  }



  const std::vector<Interpretation::DataComponentInterpretation> &
  CellFields::interpretations() const
  {
    return component_interpretations;
  }



  const dealii::DoFHandler<dim> &
  CellFields::dof_handler() const
  {
    return fields_dof_handler;
  }



  const Vector &
  CellFields::values() const
  {
    return field_values;
  }
} // namespace lumbricus
