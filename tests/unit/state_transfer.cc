// SPDX-License-Identifier: LGPL-2.1-or-later
// What a change of the mesh does to a state.
#include <lumbricus/adaptivity/mesh_record.h>
#include <lumbricus/adaptivity/state_transfer.h>
#include <lumbricus/constraints/local_constraints.h>
#include <lumbricus/core/nodal_history.h>
#include <lumbricus/discretization/cell_state.h>
#include <lumbricus/geometry/geometry.h>

#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/lac/affine_constraints.h>

#include <gtest/gtest.h>

#include <cmath>

#include "read_plugin.h"

using namespace lumbricus;

namespace
{
  // A quarter of a curved body with liquid and wall, on all ranks, and a state
  // that is not smooth.
  class StateTransfer : public ::testing::TestWithParam<bool>
  {
  protected:
    StateTransfer()
      : triangulation(MPI_COMM_WORLD)
      , space(triangulation)
    {
      read_plugin<Geometry>("open cylinder", "set Cross-section = quarter")
        ->create_coarse_mesh(triangulation);
      number();
      state = space.zero_state(outline());
      fill();
    }

    // As of a run whose skin remembers something, in the middle of a step.
    StateOutline
    outline() const
    {
      auto histories = NodalHistory::names();
      histories.insert(NodalHistory::of_boundary("the skin"));
      return {0.7, 0.6, past, histories, {{"pressure", {0.1, 0.2}}}};
    }

    void
    number()
    {
      // With displacements of its own for every second material, as under slip.
      space.distribute_dofs(
        GetParam() ?
          MixedSpace::Separate([](const auto id) { return id % 2 == 0; }) :
          MixedSpace::Separate());
    }

    static double
    noise(const dealii::Point<dim> &X, const unsigned int k)
    {
      return std::sin(7. * X[0] + 3. * k) * std::cos(5. * X[1] - k) + X[2] * k;
    }

    // At every node and for every mode some number that hangs on the place.
    void
    fill()
    {
      const dealii::FE_Q<dim> q2(MixedSpace::degree);
      CellStateWriter         writer(space, state);
      const auto              displacements =
        writer.layout.displacement_begins();
      const auto          pressures = writer.layout.pressure_begins();
      std::vector<double> values(writer.layout.size());
      for_each_cell([&](const auto &cell) {
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
            {
              const auto X = space.mapping.transform_unit_to_real_cell(
                cell, q2.unit_support_point(n));
              for (unsigned int k = 0; k < displacements.size(); ++k)
                values[displacements[k] + c * MixedSpace::n_nodes + n] =
                  noise(X, c + k * dim);
            }
        for (unsigned int k = 0; k < pressures.size(); ++k)
          for (unsigned int m = 0; m < MixedSpace::n_pressure_modes; ++m)
            values[pressures[k] + m] = noise(cell->center(), m + k);
        writer.write(cell, values);
      });
    }

    template <typename Function>
    void
    for_each_cell(const Function &function) const
    {
      for (const auto &cell : space.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned())
          function(cell);
    }

    // int f dV for an f of all displacements and pressures that is not linear:
    // alike only where the functions are.
    double
    integral() const
    {
      const dealii::FE_Q<dim>   q2(MixedSpace::degree);
      const dealii::QGauss<dim> quadrature(6);
      dealii::FEValues<dim>     shape(space.mapping,
                                  q2,
                                  quadrature,
                                  dealii::update_values |
                                    dealii::update_JxW_values);
      CellStateReader           reader(space, state);
      const auto displacements = reader.layout.displacement_begins();
      const auto pressures     = reader.layout.pressure_begins();
      std::vector<double> values;
      double              sum = 0.;
      for_each_cell([&](const auto &cell) {
        reader.read(cell, values);
        shape.reinit(dealii::Triangulation<dim>::cell_iterator(cell));
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          {
            double f = 0.;
            for (const unsigned int begin : pressures)
              {
                double p = 0.;
                for (unsigned int m = 0; m < MixedSpace::n_pressure_modes; ++m)
                  p += values[begin + m] *
                       space.fe.shape_value_component(space.pressure_dof[m],
                                                      quadrature.point(q),
                                                      dim);
                f += (1. + begin) * p * p;
              }
            for (unsigned int c = 0; c < dim; ++c)
              {
                double before = 1.;
                for (unsigned int k = 0; k < displacements.size(); ++k)
                  {
                    double u = 0.;
                    for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
                      u += shape.shape_value(n, q) *
                           values[displacements[k] + c * MixedSpace::n_nodes +
                                  n];
                    f += (c + 3 * k + 1) * u * u + u * before;
                    before = u;
                  }
              }
            sum += f * shape.JxW(q);
          }
      });
      return dealii::Utilities::MPI::sum(sum, space.communicator());
    }

    void
    change()
    {
      change_mesh(
        triangulation, space, [this]() { number(); }, state);
    }

    // Cells in a corner, so that there are hanging nodes.
    void
    refine_some()
    {
      mark_where(triangulation, [](const auto &cell) {
        return cell->center()[0] < 1. && cell->center()[1] < 1.;
      });
      change();
    }

    const std::vector<double> past = {0.6, 0.4};

    ParallelMesh triangulation;
    MixedSpace   space;
    State        state;
  };



  TEST_P(StateTransfer, RefinementChangesNoFunction)
  {
    const double before  = integral();
    const auto   n_cells = triangulation.n_global_active_cells();
    refine_some();
    EXPECT_GT(triangulation.n_global_active_cells(), n_cells);
    EXPECT_EQ(state.time, 0.7);
    EXPECT_EQ(state.last_time, 0.6);
    EXPECT_NEAR(integral() / before, 1., 1e-13);
    refine_some();
    EXPECT_NEAR(integral() / before, 1., 1e-13);
  }



  TEST_P(StateTransfer, MergingUndoesRefinement)
  {
    const State before  = state;
    const auto  refined = refined_cells(triangulation);
    refine_some();
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned() && cell->level() > 0)
        cell->set_coarsen_flag();
    change();
    ASSERT_EQ(refined_cells(triangulation), refined);

    // Unknowns may be numbered anew, but norms do not care.
    const auto expect_equal = [](const Vector &a, const Vector &b) {
      EXPECT_NEAR(a.l2_norm() / b.l2_norm(), 1., 1e-14);
    };
    expect_equal(state.solution, before.solution);
    ASSERT_EQ(state.histories.size(), 3);
    for (const auto &[name, vector] : before.histories)
      expect_equal(state.histories.at(name), vector);
    ASSERT_EQ(state.past.size(), 2);
    for (unsigned int k = 0; k < 2; ++k)
      {
        EXPECT_EQ(state.past[k].time, past[k]);
        expect_equal(state.past[k].solution, before.past[k].solution);
      }
  }



  TEST_P(StateTransfer, WhatHangsIsConforming)
  {
    triangulation.refine_global(1);
    number();
    state = space.zero_state(outline());
    fill();
    // Merge some, so that coarse cells get fine neighbours that do not fit.
    for (const auto &cell : triangulation.active_cell_iterators())
      if (cell->is_locally_owned() && cell->center()[0] < 1.)
        cell->set_coarsen_flag();
    change();
    auto hanging_nodes =
      local_constraints(space.locally_owned, space.locally_relevant);
    dealii::DoFTools::make_hanging_node_constraints(space.dof_handler,
                                                    hanging_nodes);
    hanging_nodes.close();
    EXPECT_GT(dealii::Utilities::MPI::sum(hanging_nodes.n_constraints(),
                                          space.communicator()),
              0u);
    const auto expect_conforming = [&](const Vector &solution) {
      Vector conforming = solution;
      hanging_nodes.distribute(conforming);
      conforming -= solution;
      EXPECT_LT(conforming.linfty_norm(), 1e-13);
    };
    expect_conforming(state.solution);
    for (const State::Past &earlier : state.past)
      expect_conforming(earlier.solution);
  }



  TEST_P(StateTransfer, AMeshIsMadeAnewFromItsRecord)
  {
    refine_some();
    const auto refined = refined_cells(triangulation);
    const auto n_cells = triangulation.n_global_active_cells();
    coarsen_completely(triangulation);
    EXPECT_EQ(triangulation.n_global_levels(), 1u);
    refine_cells(triangulation, refined);
    EXPECT_EQ(triangulation.n_global_active_cells(), n_cells);
    EXPECT_EQ(refined_cells(triangulation), refined);
  }

  INSTANTIATE_TEST_SUITE_P(Interface, StateTransfer, ::testing::Bool());
} // namespace
