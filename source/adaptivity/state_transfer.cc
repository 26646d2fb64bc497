// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/adaptivity/state_transfer.h>
#include <lumbricus/constraints/local_constraints.h>
#include <lumbricus/discretization/cell_state.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/distributed/cell_data_transfer.templates.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_dgp.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace lumbricus
{
  namespace
  {
    using Values         = std::vector<double>;
    using ParentIterator = dealii::Triangulation<dim>::cell_iterator;

    // Where the components of all displacements begin.
    std::vector<unsigned int>
    scalar_begins(const CellLayout &layout)
    {
      std::vector<unsigned int> begins;
      for (unsigned int c = 0; c < dim; ++c)
        for (const unsigned int begin : layout.displacement_begins())
          begins.push_back(begin + c * MixedSpace::n_nodes);
      return begins;
    }



    // to = M from, or to += M from
    void
    multiply(const dealii::FullMatrix<double> &M,
             const double                     *from,
             double                           *to)
    {
      for (unsigned int i = 0; i < M.m(); ++i)
        for (unsigned int j = 0; j < M.n(); ++j)
          to[i] += M(i, j) * from[j];
    }



    // From a cell to its children and back.
    class FamilyTransfer
    {
    public:
      explicit FamilyTransfer(const CellLayout &layout)
        : size(layout.size())
        , scalars(scalar_begins(layout))
        , pressures(layout.pressure_begins())
      {}

      std::vector<Values>
      to_children(const Values &parent) const
      {
        const unsigned int n_children =
          dealii::GeometryInfo<dim>::max_children_per_cell;
        std::vector<Values> children(n_children, Values(size));
        for (unsigned int c = 0; c < n_children; ++c)
          {
            for (const unsigned int begin : scalars)
              multiply(displacement.get_prolongation_matrix(c),
                       &parent[begin],
                       &children[c][begin]);
            for (const unsigned int begin : pressures)
              multiply(pressure.get_prolongation_matrix(c),
                       &parent[begin],
                       &children[c][begin]);
          }
        return children;
      }

      Values
      to_parent(const std::vector<Values> &children) const
      {
        Values parent(size);
        for (unsigned int c = 0; c < children.size(); ++c)
          {
            // A node of the parent is one of each child that it touches.
            const auto &injection = displacement.get_restriction_matrix(c);
            for (unsigned int i = 0; i < injection.m(); ++i)
              for (unsigned int j = 0; j < injection.n(); ++j)
                if (injection(i, j) > 0.5)
                  for (const unsigned int begin : scalars)
                    parent[begin + i] = children[c][begin + j];
            for (const unsigned int begin : pressures)
              multiply(pressure.get_restriction_matrix(c),
                       &children[c][begin],
                       &parent[begin]);
          }
        return parent;
      }

    private:
      const dealii::FE_Q<dim>   displacement{MixedSpace::degree};
      const dealii::FE_DGP<dim> pressure{MixedSpace::degree - 1};

      const unsigned int              size;
      const std::vector<unsigned int> scalars, pressures; ///< where they begin
    };



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
  } // namespace



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
            return family.to_children(parent);
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
