// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/isotropic_function.h>
#include <lumbricus/core/nodal_history.h>
#include <lumbricus/discretization/displacement_before.h>
#include <lumbricus/discretization/element_kernel.h>
#include <lumbricus/discretization/same_cell.h>
#include <lumbricus/discretization/viscous_memory.h>

#include <deal.II/lac/full_matrix.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lumbricus
{
  using dealii::SymmetricTensor;
  using dealii::Tensor;

  namespace
  {
    using cell_sizes::n_nodes;
    using cell_sizes::n_q;

    constexpr unsigned int n_parts = 2; ///< vectors that make a tensor

    // The tensor of its diagonal and of its entries 23, 31 and 12, and back.
    SymmetricTensor<2, dim>
    tensor(const std::array<Tensor<1, dim>, n_parts> &parts)
    {
      SymmetricTensor<2, dim> A;
      for (unsigned int i = 0; i < dim; ++i)
        {
          A[i][i]                           = parts[0][i];
          A[(i + 1) % dim][(i + 2) % dim] = parts[1][i];
        }
      return A;
    }



    std::array<Tensor<1, dim>, n_parts>
    parts_of(const SymmetricTensor<2, dim> &A)
    {
      std::array<Tensor<1, dim>, n_parts> parts;
      for (unsigned int i = 0; i < dim; ++i)
        {
          parts[0][i] = A[i][i];
          parts[1][i] = A[(i + 1) % dim][(i + 2) % dim];
        }
      return parts;
    }



    // Takes values at the quadrature points to those at the nodes, [n][q].
    dealii::FullMatrix<double>
    points_to_nodes(const ShapeCache &shapes)
    {
      static_assert(n_nodes == n_q, "There has to be one and only one inverse.");
      dealii::FullMatrix<double> N(n_q, n_nodes);
      for (unsigned int q = 0; q < n_q; ++q)
        for (unsigned int n = 0; n < n_nodes; ++n)
          N(q, n) = shapes.node_values(q)[n];
      N.gauss_jordan();
      return N;
    }
  } // namespace



  ViscousMemory::ViscousMemory(const Body   &body,
                               const State  &state,
                               const double t)
    : body(body)
    , state(state)
    , since(std::max(t - state.last_time, 0.))
    , indices(body.space.rest_fe.n_dofs_per_cell())
  {}



  void
  ViscousMemory::read(const OwnedCell &cell, MaterialPoint *points)
  {
    const auto   &branches = cell.tissue.viscous_branches();
    ElementKernel kernel;
    // Where the body was, which counts while a step is under way.
    std::array<SymmetricTensor<2, dim>, n_q> inverse;
    if (since > 0.)
      {
        kernel.read_history(body.space,
                            cell.iterator,
                            displacement_before.in(state),
                            indices);
        kernel.compute_deformation(body.shapes.cell(cell.index));
        for (unsigned int q = 0; q < n_q; ++q)
          inverse[q] = inverse_shape(kernel.F[q]);
      }
    for (unsigned int k = 0; k < branches.size(); ++k)
      {
        std::array<std::array<Tensor<1, dim>, n_parts>, n_q> logarithms;
        for (unsigned int part = 0; part < n_parts; ++part)
          {
            kernel.read_history(body.space,
                                cell.iterator,
                                state.histories.at(
                                  NodalHistory::of_branch(k, part)),
                                indices);
            for (unsigned int q = 0; q < n_q; ++q)
              logarithms[q][part] =
                kernel.displacement(body.shapes.node_values(q));
          }
        for (unsigned int q = 0; q < n_q; ++q)
          points[q].viscous[k] = branches[k].in_step(
            isotropic_function(tensor(logarithms[q]),
                               [](const double x) { return std::exp(x); }),
            inverse[q],
            since);
      }
  }



  std::set<std::string>
  histories_of_branches(const Anatomy &anatomy)
  {
    std::set<std::string> names;
    for (unsigned int k = 0; k < anatomy.n_viscous_branches(); ++k)
      for (unsigned int part = 0; part < n_parts; ++part)
        names.insert(NodalHistory::of_branch(k, part));
    return names;
  }



  void
  remember_branches(const Body &body, State &state)
  {
    if (body.anatomy.n_viscous_branches() == 0)
      return;
    const MixedSpace   &space    = body.space;
    const Vector        relevant = space.with_ghosts(state.solution);
    const auto          to_nodes = points_to_nodes(body.shapes);
    ViscousMemory       memory(body, state, state.time);
    ElementKernel       kernel;
    std::vector<dealii::types::global_dof_index> indices(
      space.fe.n_dofs_per_cell()),
      rest_indices(space.rest_fe.n_dofs_per_cell());
    for (const OwnedCell cell : body.owned_cells())
      {
        const auto n_branches = cell.tissue.viscous_branches().size();
        if (n_branches == 0)
          continue;
        std::array<MaterialPoint, n_q> points;
        for (MaterialPoint &point : points)
          point.viscous.resize(n_branches);
        memory.read(cell, points.data());
        kernel.read(space, cell.iterator, relevant, indices);
        kernel.compute_deformation(body.shapes.cell(cell.index));
        same_cell(cell.iterator, space.rest_dof_handler)
          ->get_dof_indices(rest_indices);
        for (unsigned int k = 0; k < n_branches; ++k)
          {
            std::array<std::array<Tensor<1, dim>, n_parts>, n_q> logarithms;
            for (unsigned int q = 0; q < n_q; ++q)
              logarithms[q] = parts_of(
                isotropic_function(points[q].viscous[k].at_end(kernel.F[q]),
                                   [](const double x) { return std::log(x); }));
            for (unsigned int part = 0; part < n_parts; ++part)
              {
                Vector &history =
                  state.histories.at(NodalHistory::of_branch(k, part));
                for (unsigned int n = 0; n < n_nodes; ++n)
                  {
                    Tensor<1, dim> value;
                    for (unsigned int q = 0; q < n_q; ++q)
                      value += to_nodes(n, q) * logarithms[q][part];
                    for (unsigned int c = 0; c < dim; ++c)
                      history[rest_indices[space.rest_dof[c][n]]] = value[c];
                  }
              }
          }
      }
  }
} // namespace lumbricus
