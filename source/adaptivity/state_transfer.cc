// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/adaptivity/family_transfer.h>
#include <lumbricus/adaptivity/state_transfer.h>
#include <lumbricus/constraints/local_constraints.h>
#include <lumbricus/discretization/cell_state.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/distributed/cell_data_transfer.templates.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/affine_constraints.h>

#include <vector>

namespace lumbricus
{
  namespace
  {
    using Values         = FamilyTransfer::Values;
    using ParentIterator = dealii::Triangulation<dim>::cell_iterator;

    std::vector<Values>
    read_all(const MixedSpace &space, const State &state)
    {
      std::vector<Values> values(space.triangulation.n_active_cells());
      CellStateReader     reader(space, state);
      for (const auto &cell : space.owned_cells())
        reader.read(cell, values[cell->active_cell_index()]);
      return values;
    }



    void
    write_all(const MixedSpace          &space,
              const std::vector<Values> &values,
              State                     &state)
    {
      state = space.zero_state(state.outline());
      CellStateWriter writer(space, state);
      for (const auto &cell : space.owned_cells())
        writer.write(cell, values[cell->active_cell_index()]);
    }
  } // namespace



  void
  make_conforming(const MixedSpace &space, State &state)
  {
    auto hanging_nodes =
      local_constraints(space.locally_owned, space.locally_relevant);
    dealii::DoFTools::make_hanging_node_constraints(space.dof_handler,
                                                    hanging_nodes);
    hanging_nodes.close();
    hanging_nodes.distribute(state.solution);
    for (State::Past &earlier : state.past)
      hanging_nodes.distribute(earlier.solution);
  }



  void
  change_mesh(ParallelMesh                &triangulation,
              const MixedSpace            &space,
              const std::function<void()> &renumber,
              State                       &state)
  {
    const FamilyTransfer family{CellLayout(state)};
    dealii::parallel::distributed::
      CellDataTransfer<dim, dim, std::vector<Values>>
        transfer(
          triangulation,
          false,
          [&](const ParentIterator & /*parent*/, const Values &parent) {
            std::vector<Values> children;
          for (unsigned int c = 0;
               c < dealii::GeometryInfo<dim>::max_children_per_cell;
               ++c)
            children.push_back(family.to_child(c, parent));
          return children;
          },
          [&](const ParentIterator & /*parent*/,
              const std::vector<Values> &children) {
            return family.to_parent(children);
          });

    const auto before = read_all(space, state);
    triangulation.prepare_coarsening_and_refinement();
    transfer.prepare_for_coarsening_and_refinement(before);
    triangulation.execute_coarsening_and_refinement();
    renumber();

    std::vector<Values> after(triangulation.n_active_cells());
    transfer.unpack(after);
    write_all(space, after, state);
    make_conforming(space, state);
  }
} // namespace lumbricus
