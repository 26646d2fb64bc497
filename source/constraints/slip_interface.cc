// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/constraints/local_constraints.h>
#include <lumbricus/constraints/slip_interface.h>
#include <lumbricus/discretization/surface_kernel.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/lac/vector.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace lumbricus
{
  using dealii::Tensor;

  namespace
  {
    // Surfaces whose normals at a node are closer than this are one.
    constexpr double cos_of_one_surface = 0.7;

    // Where two are as large the first, whatever rounding says, so that what is
    // eliminated does not change without reason.
    unsigned int
    largest_component(const Tensor<1, dim> &v)
    {
      constexpr double larger  = 1. + 1e-6;
      unsigned int     largest = 0;
      for (unsigned int c = 1; c < dim; ++c)
        if (std::abs(v[c]) > larger * std::abs(v[largest]))
          largest = c;
      return largest;
    }



    // Bring rows, of which there are at most dim, to the reduced echelon form;
    // rows without anything left are dropped. @return the pivot of each row.
    std::vector<unsigned int>
    eliminate(std::vector<Tensor<1, dim>> &rows)
    {
      std::vector<unsigned int> pivots;
      for (auto &row : rows)
        row /= row.norm();
      while (pivots.size() < rows.size())
        {
          // The row with the largest entry is next.
          const unsigned int k = pivots.size();
          for (unsigned int r = k + 1; r < rows.size(); ++r)
            if (std::abs(rows[r][largest_component(rows[r])]) >
                std::abs(rows[k][largest_component(rows[k])]))
              std::swap(rows[r], rows[k]);
          const unsigned int pivot = largest_component(rows[k]);
          if (std::abs(rows[k][pivot]) < 1e-8)
            {
              rows.resize(k);
              break;
            }
          rows[k] /= rows[k][pivot];
          for (unsigned int r = 0; r < rows.size(); ++r)
            if (r != k)
              rows[r] -= rows[r][pivot] * rows[k];
          pivots.push_back(pivot);
        }
      return pivots;
    }
  } // namespace



  SlipInterface::SlipInterface(const MixedSpace        &space,
                               const Anatomy           &anatomy,
                               const InterfaceCoupling &coupling)
    : space(space)
    , anatomy(anatomy)
    , coupling(coupling)
  {}



  bool
  SlipInterface::exists() const
  {
    return coupling.slips();
  }



  bool
  SlipInterface::follows_the_deformation() const
  {
    return coupling.follows_the_deformation();
  }



  const std::vector<SlipInterface::NodePair> &
  SlipInterface::pairs() const
  {
    return node_pairs;
  }



  void
  SlipInterface::reinit()
  {
    if (!exists())
      return;
    hanging_nodes =
      local_constraints(space.locally_owned, space.locally_relevant);
    dealii::DoFTools::make_hanging_node_constraints(space.dof_handler,
                                                    hanging_nodes);
    hanging_nodes.close();
    space.reinit_vector(moved);
    moved.update_ghost_values();
    find_pairs();
    update_normals(space.initial_state().solution);
    merge_surfaces();
  }



  template <typename Function>
  void
  SlipInterface::for_each_face(const Function &function) const
  {
    const auto is_liquid = [&](const auto &cell) {
      return anatomy.is_liquid(Region::of(cell->material_id()).tissue);
    };
    for (const auto &cell : space.dof_handler.active_cell_iterators())
      {
        if (cell->is_artificial() || !is_liquid(cell))
          continue;
        for (const unsigned int f : cell->face_indices())
          {
            if (cell->at_boundary(f))
              continue;
            const auto neighbor = cell->neighbor(f);
            // Between ghosts not everything is known, nor needed.
            if (!cell->is_locally_owned() &&
                (neighbor->has_children() || neighbor->is_artificial()))
              continue;
            Assert(!neighbor->has_children() || is_liquid(neighbor->child(0)),
                   dealii::ExcMessage("The wall is finer than the liquid."));
            if (neighbor->has_children() || is_liquid(neighbor))
              continue;
            Assert(!cell->neighbor_is_coarser(f),
                   dealii::ExcMessage("The wall is coarser than the liquid."));
            function(cell, f);
          }
      }
  }



  void
  SlipInterface::find_pairs()
  {
    node_pairs.clear();
    std::set<dealii::types::global_dof_index> found;

    const unsigned int n_face_dofs = space.fe.n_dofs_per_face();
    std::vector<dealii::types::global_dof_index> indices(
      space.fe.n_dofs_per_cell());
    std::vector<dealii::types::global_dof_index> of_liquid(n_face_dofs);
    std::vector<dealii::types::global_dof_index> of_wall(n_face_dofs);
    for_each_face([&](const auto &cell, const unsigned int f) {
      cell->get_dof_indices(indices);
      const auto face = cell->face(f);
      face->get_dof_indices(of_liquid, cell->active_fe_index());
      face->get_dof_indices(of_wall, cell->neighbor(f)->active_fe_index());

      std::array<NodePair, MixedSpace::n_nodes> pairs_of_face;
      for (unsigned int i = 0; i < n_face_dofs; ++i)
        {
          const auto [c, n] = space.fe.face_system_to_component_index(i, f);
          pairs_of_face[n].liquid[c] = of_liquid[i];
          pairs_of_face[n].wall[c]   = of_wall[i];
        }
      for (unsigned int n = 0; n < n_face_dofs / dim; ++n)
        {
          NodePair &pair = pairs_of_face[n];
          if (!found.insert(pair.liquid[0]).second)
            continue;
          const unsigned int i =
            std::find(indices.begin(), indices.end(), pair.liquid[0]) -
            indices.begin();
          pair.X = space.mapping.transform_unit_to_real_cell(
            cell, space.fe.unit_support_point(i));
          pair.segment = Region::of(cell->material_id()).segment;
          for (unsigned int s = 0; s < n_surfaces; ++s)
            pair.surface[s] = s;
          node_pairs.push_back(pair);
        }
    });
  }



  bool
  SlipInterface::is_liquid_side(
    const dealii::DoFHandler<dim>::active_cell_iterator &cell,
    const unsigned int                                   f) const
  {
    const auto is_liquid = [&](const auto &some_cell) {
      return anatomy.is_liquid(Region::of(some_cell->material_id()).tissue);
    };
    return exists() && is_liquid(cell) && !cell->at_boundary(f) &&
           !is_liquid(cell->neighbor(f));
  }



  void
  SlipInterface::update(const Vector &solution, const Vector &start)
  {
    update_normals(solution);
    space.reinit_vector(moved);
    moved.copy_locally_owned_data_from(solution);
    moved -= start;
    moved.update_ghost_values();
  }



  void
  SlipInterface::update_normals(const Vector &solution)
  {
    constexpr unsigned int n_nodes = MixedSpace::n_nodes;

    const Vector relevant = space.with_ghosts(solution);
    for (Vector &sum : m)
      space.reinit_vector(sum);

    const unsigned int     n_dofs = space.fe.n_dofs_per_cell();
    dealii::Vector<double> cell_sum(n_dofs);
    SurfaceKernel          surface(space);
    double                 u[dim][ShapeCache::padded_nodes] = {};
    std::vector<dealii::types::global_dof_index> indices(n_dofs);
    for_each_face([&](const auto &cell, const unsigned int f) {
      if (!cell->is_locally_owned())
        return;
      surface.reinit(cell, f);
      cell->get_dof_indices(indices);
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int n = 0; n < n_nodes; ++n)
          u[c][n] = relevant(indices[space.displacement_dof[c][n]]);
      cell_sum = 0.;
      Tensor<1, dim> N_of_face;
      for (unsigned int q = 0; q < surface.n_points(); ++q)
        {
          surface.set(q, u);
          const Tensor<1, dim> N_dA = surface.N * surface.JxW;
          const Tensor<1, dim> n_da = dealii::cofactor(surface.F) * N_dA;
          N_of_face += N_dA;
          for (unsigned int n = 0; n < n_nodes; ++n)
            for (unsigned int c = 0; c < dim; ++c)
              cell_sum(space.displacement_dof[c][n]) +=
                surface.values[n] * n_da[c];
        }
      hanging_nodes.distribute_local_to_global(cell_sum,
                                               indices,
                                               m[largest_component(N_of_face)]);
    });
    for (Vector &sum : m)
      {
        sum.compress(dealii::VectorOperation::add);
        sum.update_ghost_values();
      }
  }



  void
  SlipInterface::merge_surfaces()
  {
    for (NodePair &pair : node_pairs)
      for (unsigned int s = 1; s < n_surfaces; ++s)
        for (unsigned int other = 0; other < s; ++other)
          {
            Tensor<1, dim> a, b;
            for (unsigned int c = 0; c < dim; ++c)
              {
                a[c] = m[s](pair.liquid[c]);
                b[c] = m[other](pair.liquid[c]);
              }
            if (a * b > cos_of_one_surface * a.norm() * b.norm())
              pair.surface[s] = pair.surface[other];
          }
  }



  std::vector<Tensor<1, dim>>
  SlipInterface::normals(const NodePair &pair) const
  {
    std::array<Tensor<1, dim>, n_surfaces> sums;
    for (unsigned int s = 0; s < n_surfaces; ++s)
      for (unsigned int c = 0; c < dim; ++c)
        sums[pair.surface[s]][c] += m[s](pair.liquid[c]);

    double largest = 0.;
    for (const auto &sum : sums)
      largest = std::max(largest, sum.norm());
    std::vector<Tensor<1, dim>> result;
    for (const auto &sum : sums)
      if (sum.norm() > 1e-8 * largest)
        result.push_back(sum);
    return result;
  }



  double
  SlipInterface::add_constraints(
    dealii::AffineConstraints<double> &constraints) const
  {
    double largest = 0.;
    for (const NodePair &pair : node_pairs)
      {
        if (!constraints.can_store_line(pair.liquid[0]) ||
            hanging_nodes.is_constrained(pair.liquid[0]))
          continue;

        std::vector<Tensor<1, dim>> rows;
        for (const auto &normal : normals(pair))
          {
            Tensor<1, dim> row = normal;
            for (unsigned int c = 0; c < dim; ++c)
              if (constraints.is_constrained(pair.liquid[c]))
                row[c] = 0.;
            if (row.norm() > 1e-6 * normal.norm())
              rows.push_back(row);
          }

        // Row r reads du_liquid[p] = sum_c row[c] du_wall[c]
        //                          - sum_{c != p} row[c] du_liquid[c]
        //                          - sum_c row[c] slip[c].
        const auto pivots = eliminate(rows);
        for (unsigned int r = 0; r < pivots.size(); ++r)
          {
            const auto line = pair.liquid[pivots[r]];
            constraints.add_line(line);
            double off = 0.;
            for (unsigned int c = 0; c < dim; ++c)
              {
                if (std::abs(rows[r][c]) < 1e-14)
                  continue;
                off += rows[r][c] *
                       (moved(pair.liquid[c]) - moved(pair.wall[c]));
                constraints.add_entry(line, pair.wall[c], rows[r][c]);
                if (c != pivots[r])
                  constraints.add_entry(line, pair.liquid[c], -rows[r][c]);
              }
            constraints.set_inhomogeneity(line, -off);
            largest = std::max(largest, std::abs(off));
          }
      }
    return largest;
  }
} // namespace lumbricus
