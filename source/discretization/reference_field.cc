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
    points.assign(shapes.n_owned_cells() * n_q, ReferencePoint());
    active_fibres.assign(shapes.n_owned_cells(), {});

    for_each_region(space, [&](const unsigned int i, const Region region) {
      const auto &muscles = anatomy.muscles_of(region.tissue);
      if (muscles.empty())
        return;
      active_fibres[i].resize(n_q);
      for (unsigned int q = 0; q < n_q; ++q)
        for (const Muscle *muscle : muscles)
          active_fibres[i][q].push_back(
            {muscle->fibre_direction(shapes.quadrature_point(i, q)), 1.});
    });
  }



  void
  ReferenceField::update_muscles(const LoadTime &t)
  {
    for_each_region(space, [&](const unsigned int i, const Region region) {
      const auto &muscles = anatomy.muscles_of(region.tissue);
      if (muscles.empty())
        return;
      for (unsigned int q = 0; q < n_q; ++q)
        {
          auto &fibres = active_fibres[i][q];
          for (unsigned int k = 0; k < fibres.size(); ++k)
            fibres[k].lambda =
              muscles[k]->active_stretch(t,
                                         region.segment + 1,
                                         shapes.quadrature_point(i, q));
          points[i * n_q + q] = active_stretch_map(fibres);
        }
    });
  }



  void
  ReferenceField::update_liquid(const State &state)
  {
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
              rest.u[c][n]     = state.rest_displacement[index];
              volume.u[c][n]   = state.volume_displacement[index];
            }
        rest.compute_deformation(shapes.cell(i));
        volume.compute_deformation(shapes.cell(i));
        for (unsigned int q = 0; q < n_q; ++q)
          points[i * n_q + q] = rest_shape_map(rest.F[q], volume.F[q]);
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



  const ReferencePoint *
  ReferenceField::cell(const unsigned int owned_index) const
  {
    return points.data() + owned_index * n_q;
  }



  const std::vector<std::vector<ActiveFibre>> &
  ReferenceField::fibres(const unsigned int owned_index) const
  {
    return active_fibres[owned_index];
  }
} // namespace lumbricus
