// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/same_cell.h>
#include <lumbricus/discretization/surface_terms.h>
#include <lumbricus/output/cell_fields.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/types.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_tools.h>

#include <cmath>
#include <utility>

#include "cavity_points.h"

namespace lumbricus
{
  namespace
  {
    constexpr unsigned int n_q = MixedSpace::n_q_points;

    unsigned int
    n_components(const std::vector<FieldArray> &arrays)
    {
      unsigned int n = 0;
      for (const FieldArray &array : arrays)
        n += array.field->n_components();
      return n;
    }
  } // namespace



  CellFields::CellFields(const Body                    &body,
                         const ReferenceField          &references,
                         const LiquidWeight            &weight,
                         const BoundaryConditions      &conditions,
                         const std::vector<FieldArray> &arrays)
    : body(body)
    , references(references)
    , weight(weight)
    , conditions(conditions)
    , fields_dof_handler(body.space.triangulation)
  {
    for (const FieldArray &array : arrays)
      (array.field->kind() == Field::Kind::scalar_per_cell ? per_cell : nodal)
        .push_back(array);

    const dealii::FE_DGQ<dim> scalar(MixedSpace::degree);
    fe = std::make_unique<dealii::FESystem<dim>>(scalar, n_components(nodal));
    projection.reinit(scalar.n_dofs_per_cell(), n_q);
    dealii::FETools::compute_projection_from_quadrature_points_matrix(
      scalar, body.space.quadrature, body.space.quadrature, projection);
  }



  void
  CellFields::reinit()
  {
    fields_dof_handler.distribute_dofs(*fe);
    field_values.reinit(fields_dof_handler.locally_owned_dofs(),
                        dealii::DoFTools::extract_locally_relevant_dofs(
                          fields_dof_handler),
                        body.space.communicator());
    values_per_cell.assign(per_cell.size(),
                           dealii::Vector<double>(
                             body.space.triangulation.n_active_cells()));
  }



  void
  CellFields::update(const State &state)
  {
    field_values.zero_out_ghost_values();
    std::vector<dealii::types::global_dof_index> indices(fe->n_dofs_per_cell());
    std::vector<std::vector<double>>             values(
      n_q, std::vector<double>(fe->n_components()));

    const auto finish_cell = [&](FieldPoint &point) {
      for (unsigned int i = 0; i < per_cell.size(); ++i)
        {
          point.muscle = per_cell[i].muscle;
          per_cell[i].field->get(
            point, &values_per_cell[i][point.cell->active_cell_index()]);
        }
      same_cell(point.cell, fields_dof_handler)->get_dof_indices(indices);
      for (unsigned int k = 0; k < fe->n_dofs_per_cell(); ++k)
        {
          const auto [component, node] = fe->system_to_component_index(k);
          double value                 = 0.;
          for (unsigned int q = 0; q < n_q; ++q)
            value += projection(node, q) * values[q][component];
          field_values(indices[k]) = value;
        }
    };
    visit_points(body, references, weight, state, [&](FieldPoint &point) {
      get_nodal(point, values[point.q].data());
      if (point.q + 1 == n_q)
        finish_cell(point);
    });
    update_skin(state);
    field_values.update_ghost_values();
    update_filling_cells(state);
  }



  void
  CellFields::update_skin(const State &state)
  {
    // Where the components of each begin.
    std::vector<std::pair<const SurfaceField *, unsigned int>> on_skin;
    unsigned int                                               component = 0;
    for (const FieldArray &array : nodal)
      {
        const auto *field = dynamic_cast<const SurfaceField *>(array.field);
        if (field != nullptr)
          on_skin.emplace_back(field, component);
        component += array.field->n_components();
      }
    if (on_skin.empty())
      return;

    const MixedSpace &space = body.space;
    std::vector<dealii::types::global_dof_index> indices(fe->n_dofs_per_cell());
    std::vector<double> values(fe->n_components());
    SurfaceTerms(body, conditions)
      .visit_cell_nodes(
        state,
        [&](const OwnedCell    &cell,
            const unsigned int  node,
            const unsigned int  condition,
            const SurfacePoint &point) {
          same_cell(cell.iterator, fields_dof_handler)
            ->get_dof_indices(indices);
          // Nodes are in rows of three here.
          const auto x =
            space.fe.unit_support_point(space.displacement_dof[0][node]);
          const unsigned int place =
            std::round(2. * x[0] + 6. * x[1] + 18. * x[2]);
          const SurfaceTerm &term =
            *conditions.condition(condition).surface_term();
          for (const auto &[field, first] : on_skin)
            {
              field->get_on_skin(term, point, values.data());
              for (unsigned int c = 0; c < field->n_components(); ++c)
                field_values(
                  indices[fe->component_to_system_index(first + c, place)]) +=
                  values[c];
            }
        });
  }



  void
  CellFields::update_filling_cells(const State &state)
  {
    constexpr unsigned int n_nodes = MixedSpace::n_nodes;
    filling.clear();
    std::vector<double> values(fe->n_components());
    visit_cavity_points(body, weight, state, [&](FieldPoint &point) {
      if (point.q == 0)
        {
          filling.emplace_back();
          filling.back().nodal.resize(values.size() * n_nodes);
          filling.back().per_cell.resize(per_cell.size());
          for (unsigned int i = 0; i < per_cell.size(); ++i)
            {
              point.muscle = per_cell[i].muscle;
              per_cell[i].field->get(point, &filling.back().per_cell[i]);
            }
        }
      FillingCell &cell = filling.back();
      cell.X[point.q]   = point.X;
      get_nodal(point, values.data());
      for (unsigned int c = 0; c < values.size(); ++c)
        cell.nodal[c * n_nodes + point.q] = values[c];
    });
  }



  void
  CellFields::get_nodal(FieldPoint &point, double *next) const
  {
    for (const FieldArray &array : nodal)
      {
        point.muscle = array.muscle;
        array.field->get(point, next);
        next += array.field->n_components();
      }
  }



  const std::vector<FieldArray> &
  CellFields::nodal_arrays() const
  {
    return nodal;
  }



  const std::vector<FieldArray> &
  CellFields::cell_arrays() const
  {
    return per_cell;
  }



  std::vector<unsigned int>
  CellFields::components(const std::string &name) const
  {
    std::vector<unsigned int> found;
    unsigned int              component = 0;
    for (const FieldArray &array : nodal)
      for (unsigned int c = 0; c < array.field->n_components(); ++c)
        {
          if (array.name == name)
            found.push_back(component);
          ++component;
        }
    Assert(!found.empty(),
           dealii::ExcMessage("There is no field '" + name + "'."));
    return found;
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



  const std::vector<FillingCell> &
  CellFields::filling_cells() const
  {
    return filling;
  }



  const dealii::Vector<double> &
  CellFields::cell_values(const unsigned int i) const
  {
    AssertIndexRange(i, values_per_cell.size());
    return values_per_cell[i];
  }
} // namespace lumbricus
