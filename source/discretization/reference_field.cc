// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/cell_sizes.h>
#include <lumbricus/discretization/element_kernel.h>
#include <lumbricus/discretization/reference_field.h>

#include <deal.II/grid/filtered_iterator.h>

namespace lumbricus
{
  namespace
  {
    using cell_sizes::n_q;

    // Call function(owned_index, region) for all owned cells; an ExcInput on
    // one rank is thrown on all.
    template <typename Function>
    void
    for_each_region(const MixedSpace &space, const Function &function)
    {
      std::string message;
      try
        {
          unsigned int index = 0;
          for (const auto &cell : space.dof_handler.active_cell_iterators() |
                                    dealii::IteratorFilters::LocallyOwnedCell())
            function(index++, Region::of(cell->material_id()));
        }
      catch (const ExcInput &exception)
        {
          message = plain_message(exception);
        }
      throw_on_all_ranks<ExcInput>(message, space.communicator());
    }
  } // namespace



  ReferenceField::ReferenceField(const MixedSpace &space,
                                 const ShapeCache &shapes,
                                 const Anatomy    &anatomy)
    : space(space)
    , shapes(shapes)
    , anatomy(anatomy)
  {}



  void
  ReferenceField::reinit()
  {
    points.assign(shapes.n_owned_cells() * n_q, MaterialPoint());

    for_each_region(space, [&](const unsigned int i, const Region region) {
      for (unsigned int q = 0; q < n_q; ++q)
        for (const Muscle *muscle : anatomy.muscles_of(region.tissue))
          points[i * n_q + q].fibres.push_back(
            {muscle->fibre_direction(shapes.quadrature_point(i, q)),
             muscle->action().at_rest()});
    });
  }



  void
  ReferenceField::update_muscles(const LoadTime &t)
  {
    for_each_region(space, [&](const unsigned int i, const Region region) {
      const Tissue &tissue  = anatomy.tissue(region.tissue);
      const auto   &muscles = tissue.muscles();
      if (muscles.empty())
        return;
      for (unsigned int q = 0; q < n_q; ++q)
        {
          MaterialPoint &point = points[i * n_q + q];
          for (unsigned int k = 0; k < muscles.size(); ++k)
            point.fibres[k].activation =
              muscles[k]->activation(t,
                                     region.segment + 1,
                                     shapes.quadrature_point(i, q));
          point.reference = tissue.reference_map(point.fibres);
        }
    });
  }



  void
  ReferenceField::update_liquid(const State &state)
  {
    const Vector &u_ref = rest_displacement.in(state);
    const Vector &u_vol = volume_displacement.in(state);
    ElementKernel                                rest, volume;
    std::vector<dealii::types::global_dof_index> indices(
      space.rest_fe.n_dofs_per_cell());
    unsigned int index = 0;
    for (const auto &cell : space.rest_dof_handler.active_cell_iterators() |
                              dealii::IteratorFilters::LocallyOwnedCell())
      {
        const unsigned int i = index++;
        if (!anatomy.is_liquid(Region::of(cell->material_id()).tissue))
          continue;
        cell->get_dof_indices(indices);
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
            {
              const auto index = indices[space.rest_dof[c][n]];
              rest.u[c][n]     = u_ref[index];
              volume.u[c][n]   = u_vol[index];
            }
        rest.compute_deformation(shapes.cell(i));
        volume.compute_deformation(shapes.cell(i));
        for (unsigned int q = 0; q < n_q; ++q)
          points[i * n_q + q].reference =
            rest_shape_map(rest.F[q], volume.F[q]);
      }
  }



  void
  ReferenceField::update(const State &state, const LoadTime &t)
  {
    update_muscles(t);
    update_liquid(state);
  }



  void
  ReferenceField::update(const State &state)
  {
    update(state, state.time);
  }



  const MaterialPoint *
  ReferenceField::cell(const unsigned int owned_index) const
  {
    return points.data() + owned_index * n_q;
  }
} // namespace lumbricus
