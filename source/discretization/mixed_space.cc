// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/discretization/mixed_space.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_dgp.h>
#include <deal.II/fe/fe_dgq.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_tools.h>

namespace lumbricus
{
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
  }



  void
  MixedSpace::distribute_dofs()
  {
    mapping.initialize(dealii::MappingQ<dim>(degree), triangulation);
    dof_handler.distribute_dofs(fe);
    rest_dof_handler.distribute_dofs(rest_fe);
    locally_owned = dof_handler.locally_owned_dofs();
    dealii::DoFTools::extract_locally_relevant_dofs(dof_handler,
                                                    locally_relevant);
  }



  State
  MixedSpace::initial_state() const
  {
    State state;
    state.solution.reinit(locally_owned, communicator());
    state.rest_displacement.reinit(rest_dof_handler.locally_owned_dofs(),
                                   communicator());
    return state;
  }



  MPI_Comm
  MixedSpace::communicator() const
  {
    return triangulation.get_communicator();
  }
} // namespace lumbricus
