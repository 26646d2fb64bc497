// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/nodal_history.h>
#include <lumbricus/discretization/mixed_space.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_dgp.h>
#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_tools.h>

#include <string>

namespace lumbricus
{
  namespace
  {
    dealii::FESystem<dim>
    separate_fe(const bool liquid)
    {
      const dealii::FE_Q<dim>       displacement(MixedSpace::degree);
      const dealii::FE_Nothing<dim> nothing;
      const dealii::FE_DGP<dim>     pressure(MixedSpace::degree - 1);
      return liquid ? dealii::FESystem<dim>(
                        nothing, dim, displacement, dim, pressure, 1) :
                      dealii::FESystem<dim>(
                        displacement, dim, nothing, dim, pressure, 1);
    }
  } // namespace



  MixedSpace::MixedSpace(const dealii::Triangulation<dim> &triangulation)
    : triangulation(triangulation)
    , fe(dealii::FE_Q<dim>(degree), dim, dealii::FE_DGP<dim>(degree - 1), 1)
    , rest_fe(dealii::FE_DGQ<dim>(degree), dim)
    , quadrature(degree + 1)
    , face_quadrature(degree + 1)
    , displacement(0)
    , pressure(dim)
    , mapping(degree)
    , dof_handler(triangulation)
    , rest_dof_handler(triangulation)
    , shape(degree)
    , separate_fes(separate_fe(false), separate_fe(true))
  {
    const auto lexicographic =
      dealii::FETools::hierarchic_to_lexicographic_numbering<dim>(degree);
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int n = 0; n < n_nodes; ++n)
        {
          displacement_dof[c][n] = fe.component_to_system_index(c, n);
          rest_dof[c][n] =
            rest_fe.component_to_system_index(c, lexicographic[n]);
          Assert(fe.unit_support_point(displacement_dof[c][n])
                     .distance(rest_fe.unit_support_point(rest_dof[c][n])) <
                   1e-12,
                 dealii::ExcInternalError());
        }
    for (unsigned int m = 0; m < n_pressure_modes; ++m)
      pressure_dof[m] = fe.component_to_system_index(dim, m);

    // Wall and liquid have the first and the second three components.
    for (unsigned int i = 0; i < fe.n_dofs_per_cell(); ++i)
      {
        const auto [c, n] = fe.system_to_component_index(i);
        for (const unsigned int liquid : {0, 1})
          {
            const auto &separate = separate_fes[liquid];
            (void)c, (void)n, (void)separate;
            AssertDimension(separate.n_dofs_per_cell(), fe.n_dofs_per_cell());
            AssertDimension(separate.system_to_component_index(i).first,
                            c == dim ? 2 * dim : c + liquid * dim);
            AssertDimension(separate.system_to_component_index(i).second, n);
          }
      }
  }



  void
  MixedSpace::distribute_dofs(const Separate &separate)
  {
    mapping.initialize(
      triangulation,
      [this](const dealii::Triangulation<dim>::cell_iterator &cell) {
        return shape.points(cell);
      });
    if (separate)
      {
        for (const auto &cell : owned_cells())
          cell->set_active_fe_index(separate(cell->material_id()));
        dof_handler.distribute_dofs(separate_fes);
      }
    else
      dof_handler.distribute_dofs(fe);
    rest_dof_handler.distribute_dofs(rest_fe);
    locally_owned = dof_handler.locally_owned_dofs();
    locally_relevant =
      dealii::DoFTools::extract_locally_relevant_dofs(dof_handler);
    owned = std::make_shared<const Partitioner>(locally_owned, communicator());
    relevant = std::make_shared<const Partitioner>(locally_owned,
                                                   locally_relevant,
                                                   communicator());
    rest_owned =
      std::make_shared<const Partitioner>(rest_dof_handler.locally_owned_dofs(),
                                          communicator());
  }



  void
  MixedSpace::set_finest_curved_level(const unsigned int level)
  {
    shape.set_finest_curved_level(level);
  }



  State
  MixedSpace::initial_state() const
  {
    StateOutline outline;
    outline.histories = NodalHistory::names();
    return zero_state(outline);
  }



  State
  MixedSpace::zero_state(const StateOutline &outline) const
  {
    State state;
    state.time      = outline.time;
    state.last_time = outline.last_time;
    state.globals   = outline.globals;
    state.solution.reinit(owned);
    for (const std::string &name : outline.histories)
      state.histories[name].reinit(rest_owned);
    for (const double t : outline.past)
      state.past.push_back({t, state.solution});
    return state;
  }



  Vector
  MixedSpace::with_ghosts(const Vector &solution) const
  {
    Vector ghosted;
    reinit_vector(ghosted);
    ghosted.copy_locally_owned_data_from(solution);
    ghosted.update_ghost_values();
    return ghosted;
  }



  void
  MixedSpace::reinit_vector(Vector &x) const
  {
    x.reinit(relevant);
  }



  dealii::IteratorRange<
    dealii::FilteredIterator<dealii::DoFHandler<dim>::active_cell_iterator>>
  MixedSpace::owned_cells() const
  {
    return dof_handler.active_cell_iterators() |
           dealii::IteratorFilters::LocallyOwnedCell();
  }



  MPI_Comm
  MixedSpace::communicator() const
  {
    return triangulation.get_communicator();
  }
} // namespace lumbricus
