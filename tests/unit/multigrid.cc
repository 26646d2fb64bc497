// SPDX-License-Identifier: LGPL-2.1-or-later
// The parts of geometric multigrid on a block with hanging nodes, and its
// solutions against those of a direct solver.
#include <lumbricus/adaptivity/mark_where.h>
#include <lumbricus/geometry/geometry.h>
#include <lumbricus/linear/linear_solver.h>
#include <lumbricus/multigrid/v_cycle.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/grid/grid_generator.h>

#include <gtest/gtest.h>

#include <cmath>

#include "read_plugin.h"

using namespace lumbricus;

namespace
{
  // An incompressible block, held on one side, half of which is refined more
  // often, on all ranks.
  class MultigridBlock : public ::testing::Test
  {
  protected:
    MultigridBlock()
      : triangulation(MPI_COMM_WORLD)
      , space(triangulation)
      , shapes(space)
      , unknowns(space)
      , tangent(space, shapes, unknowns)
    {
      dealii::GridGenerator::subdivided_hyper_rectangle(
        triangulation, {2, 1, 1}, {0., 0., 0.}, {2., 1., 1.3}, true);
      triangulation.refine_global(2);
      mark_where(triangulation,
                 [](const auto &cell) { return cell->center()[0] < 0.7; });
      triangulation.execute_coarsening_and_refinement();
      parameters.n_coarsest = 0;
    }

    // With or without the support at x = 0.
    void
    make(const bool held)
    {
      space.distribute_dofs();
      shapes.reinit();
      constraints.reinit(space.locally_relevant);
      dealii::DoFTools::make_hanging_node_constraints(space.dof_handler,
                                                      constraints);
      std::vector<bool> displacements(dim + 1, true);
      displacements[dim] = false;
      if (held)
        dealii::DoFTools::make_zero_boundary_constraints(space.dof_handler,
                                                         0,
                                                         constraints,
                                                         displacements);
      constraints.close();
      unknowns.reinit(constraints);
      tangent.reinit();

      // A soft and a stiff part; A is that of small strains, symmetric.
      unsigned int i = 0;
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned())
          {
            const double     mu = cell->center()[1] < 0.5 ? 1. : 1e-2;
            MaterialResponse response{};
            for (unsigned int a = 0; a < dim; ++a)
              for (unsigned int b = 0; b < dim; ++b)
                {
                  response.A[dim * a + b][dim * a + b] += mu;
                  response.A[dim * a + b][dim * b + a] += mu;
                }
            response.Q = dealii::unit_symmetric_tensor<dim, double>();
            for (unsigned int q = 0; q < MixedSpace::n_q_points; ++q)
              tangent.cell(i).set(q, response, shapes.cell(i).JxW[q]);
            tangent.shear_modulus[i++] = mu;
          }
    }

    static Vector
    zero(const CellUnknowns &on)
    {
      Vector x;
      on.reinit_vector(x);
      return x;
    }

    // A vector with noise in the free unknowns, the same on any number of
    // ranks up to their order.
    Vector
    noise(const CellUnknowns &on, const double seed) const
    {
      Vector x = zero(on);
      for (unsigned int k = 0; k < x.locally_owned_size(); ++k)
        if (!on.is_constrained()[k])
          x.local_element(k) =
            std::sin(seed * (1. + x.get_partitioner()->local_to_global(k)));
      return x;
    }

    // x^T K x of the cells of a level.
    double
    energy(const VCycle &v_cycle, const unsigned int l, Vector &x) const
    {
      constexpr unsigned int n     = CellUnknowns::n_per_cell;
      const Level           &level = v_cycle.meshes().level(l);
      std::vector<double>    values(n), K;
      double                 sum = 0.;
      x.update_ghost_values();
      for (unsigned int i = 0; i < level.n_owned_cells; ++i)
        {
          level.unknowns->read_free(i, x, values.data());
          if (l + 1 == v_cycle.meshes().n_levels())
            tangent.cell_matrix(i, K);
          else
            K = v_cycle.cell_matrix(l, i);
          for (unsigned int r = 0; r < n; ++r)
            for (unsigned int s = 0; s < n; ++s)
              sum += values[r] * K[r * n + s] * values[s];
        }
      x.zero_out_ghost_values();
      return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
    }

    ParallelMesh                      triangulation;
    MixedSpace                        space;
    ShapeCache                        shapes;
    CellUnknowns                      unknowns;
    Tangent                           tangent;
    dealii::AffineConstraints<double> constraints;
    VCycleParameters                  parameters;
  };



  TEST_F(MultigridBlock, LevelsHaveTheUnknownsOfTheirMeshes)
  {
    make(true);
    Hierarchy hierarchy;
    hierarchy.reinit(space, unknowns, 0, VCycleParameters().thin);
    ASSERT_EQ(hierarchy.n_levels(), 4u);
    // Of 2 x 1 x 1 cells and their refinements.
    EXPECT_EQ(hierarchy.level(0).n_unknowns, 3u * 5 * 3 * 3 + 4 * 2);
    EXPECT_EQ(hierarchy.level(1).n_unknowns, 3u * 9 * 5 * 5 + 4 * 16);
    EXPECT_EQ(hierarchy.level(3).n_unknowns, space.dof_handler.n_dofs());
  }



  TEST_F(MultigridBlock, ProlongationOfAQuadraticIsExact)
  {
    make(false);
    const VCycle                                 v_cycle(tangent, parameters);
    Vector                                       exact = zero(unknowns);
    std::vector<dealii::types::global_dof_index> indices(
      space.fe.n_dofs_per_cell());
    for (const auto &cell : space.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell->get_dof_indices(indices);
          for (unsigned int c = 0; c < dim; ++c)
            for (const unsigned int i : space.displacement_dof[c])
              if (space.locally_owned.is_element(indices[i]))
                {
                  const auto X = space.mapping.transform_unit_to_real_cell(
                    cell, space.fe.unit_support_point(i));
                  exact(indices[i]) =
                    (c + 1.) * X[0] * X[1] - X[2] * X[c] + X[1];
                }
        }
    const auto &hierarchy = v_cycle.meshes();
    Vector      x         = zero(*hierarchy.level(0).unknowns);
    const auto  inject    = [&](const Level &level, Vector &on_level) {
      on_level = zero(*level.unknowns);
      for (unsigned int k = 0; k < level.on_finest.size(); ++k)
        if (level.on_finest[k] != dealii::numbers::invalid_unsigned_int)
          on_level.local_element(k) = exact.local_element(level.on_finest[k]);
    };
    inject(hierarchy.level(0), x);
    for (unsigned int l = 0; l + 1 < hierarchy.n_levels(); ++l)
      {
        Vector fine = zero(*hierarchy.level(l + 1).unknowns);
        v_cycle.prolongate_and_add(l, x, fine);
        x = fine;
      }
    for (unsigned int k = 0; k < x.locally_owned_size(); ++k)
      if (!unknowns.is_constrained()[k])
        {
          EXPECT_NEAR(x.local_element(k), exact.local_element(k), 1e-12);
        }
  }



  TEST_F(MultigridBlock, RestrictionIsTheTransposeOfProlongation)
  {
    make(true);
    const VCycle v_cycle(tangent, parameters);
    for (unsigned int l = 0; l + 1 < v_cycle.meshes().n_levels(); ++l)
      {
        const CellUnknowns &below = *v_cycle.meshes().level(l).unknowns;
        const CellUnknowns &above = *v_cycle.meshes().level(l + 1).unknowns;
        const Vector        x = noise(below, 1.), y = noise(above, 2.);
        Vector              Px = zero(above), PTy = zero(below);
        v_cycle.prolongate_and_add(l, x, Px);
        v_cycle.restrict_to(l, y, PTy);
        EXPECT_NEAR(Px * y, x * PTy, 1e-11 * x.l2_norm() * y.l2_norm());
      }
  }



  TEST_F(MultigridBlock, CoarseMatricesAreThoseOfTheProlongatedFunctions)
  {
    make(true);
    VCycle v_cycle(tangent, parameters);
    v_cycle.factor();
    for (unsigned int l = 0; l + 1 < v_cycle.meshes().n_levels(); ++l)
      {
        Vector x  = noise(*v_cycle.meshes().level(l).unknowns, 3.);
        Vector Px = zero(*v_cycle.meshes().level(l + 1).unknowns);
        v_cycle.prolongate_and_add(l, x, Px);
        const double coarse = energy(v_cycle, l, x);
        EXPECT_NEAR(coarse,
                    energy(v_cycle, l + 1, Px),
                    1e-11 * std::abs(coarse));
      }
  }



  TEST_F(MultigridBlock, SolvesAsTheDirectSolverDoes)
  {
    make(true);
    const auto direct    = read_plugin<LinearSolver>("direct");
    const auto multigrid = read_plugin<LinearSolver>(
      "multigrid", "set Coarsest unknowns = 0\nset Most iterations = 40");
    Vector b = noise(unknowns, 0.7), x = zero(unknowns), y = zero(unknowns);
    direct->reinit(tangent);
    direct->solve(x, b, 1e-9);
    multigrid->reinit(tangent);
    multigrid->solve(y, b, 1e-9);
    y -= x;
    EXPECT_LT(y.linfty_norm(), 1e-5 * x.linfty_norm());
  }
} // namespace
