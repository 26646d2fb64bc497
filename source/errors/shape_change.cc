// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/adaptivity/state_transfer.h>
#include <lumbricus/errors/shape_change.h>

#include <deal.II/base/tensor.h>
#include <deal.II/fe/fe_q.h>

#include <array>
#include <utility>
#include <vector>

namespace lumbricus
{
  namespace
  {
    constexpr unsigned int n_nodes = MixedSpace::n_nodes;

    // Where the nodes of the large cells are, as displacements.
    State
    positions(const Body &large, const StateOutline &outline)
    {
      const MixedSpace &space = large.space;
      State             state = space.zero_state(outline);
      std::vector<dealii::types::global_dof_index> indices(
        space.fe.n_dofs_per_cell());
      for (const OwnedCell cell : large.owned_cells())
        {
          cell.iterator->get_dof_indices(indices);
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int n = 0; n < n_nodes; ++n)
              {
                const auto index = indices[space.displacement_dof[c][n]];
                if (space.locally_owned.is_element(index))
                  state.solution(index) = large.shapes.node(cell.index, n)[c];
              }
        }
      return state;
    }



    // Derivatives of all shape functions at all nodes, [node][function].
    std::vector<std::array<dealii::Tensor<1, dim>, n_nodes>>
    derivatives_at_nodes()
    {
      const dealii::FE_Q<dim> fe(MixedSpace::degree);
      std::vector<std::array<dealii::Tensor<1, dim>, n_nodes>> result(n_nodes);
      for (unsigned int n = 0; n < n_nodes; ++n)
        for (unsigned int m = 0; m < n_nodes; ++m)
          result[n][m] = fe.shape_grad(m, fe.unit_support_point(n));
      return result;
    }
  } // namespace



  void
  follow_shape(const Body         &large,
               const Body         &small,
               const CellUnknowns &small_unknowns,
               const CutCells     &cells,
               State              &state)
  {
    using Nodes = std::array<dealii::Tensor<1, dim>, n_nodes>;
    const StateOutline outline = small.space.initial_state().outline();
    State              on_small = small.space.zero_state(outline);
    cells.prolongate(positions(large, outline), on_small);

    Vector X, u, more, weights;
    for (const auto &[vector, from] :
         {std::make_pair(&X, &on_small), std::make_pair(&u, &state)})
      {
        small_unknowns.reinit_vector(*vector);
        vector->copy_locally_owned_data_from(from->solution);
        vector->update_ghost_values();
      }
    small_unknowns.reinit_vector(more);
    weights                = more;
    const auto derivatives = derivatives_at_nodes();
    for (const OwnedCell cell : small.owned_cells())
      {
        const double              mu     = cell.tissue.shear_modulus();
        const unsigned int *const places = small_unknowns.places(cell.index);
        const auto                read   = [&](const Vector &x) {
          Nodes values;
          for (unsigned int n = 0; n < n_nodes; ++n)
            for (unsigned int c = 0; c < dim; ++c)
              values[n][c] =
                x.local_element(places[CellUnknowns::displacement(c, n)]);
          return values;
        };
        const Nodes X_of_large = read(X), u_of_large = read(u);
        for (unsigned int n = 0; n < n_nodes; ++n)
          {
            dealii::Tensor<2, dim> of_X, of_u;
            for (unsigned int m = 0; m < n_nodes; ++m)
              {
                of_X += outer_product(X_of_large[m], derivatives[n][m]);
                of_u += outer_product(u_of_large[m], derivatives[n][m]);
              }
            dealii::Tensor<1, dim> way;
            for (unsigned int c = 0; c < dim; ++c)
              way[c] = small.shapes.node(cell.index, n)[c] - X_of_large[n][c];
            const auto du = of_u * (invert(of_X) * way);
            for (unsigned int c = 0; c < dim; ++c)
              {
                const unsigned int place =
                  places[CellUnknowns::displacement(c, n)];
                more.local_element(place) += mu * du[c];
                weights.local_element(place) += mu;
              }
          }
      }
    more.compress(dealii::VectorOperation::add);
    weights.compress(dealii::VectorOperation::add);
    for (unsigned int i = 0; i < more.locally_owned_size(); ++i)
      if (weights.local_element(i) > 0.)
        state.solution.local_element(i) +=
          more.local_element(i) / weights.local_element(i);
    make_conforming(small.space, state);
  }
} // namespace lumbricus
