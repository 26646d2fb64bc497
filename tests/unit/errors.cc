// SPDX-License-Identifier: LGPL-2.1-or-later
// What estimates of errors are made of, on a body with muscle, liquid, planes of
// symmetry and hanging nodes.
#include <lumbricus/errors/cut_cells.h>
#include <lumbricus/errors/enrichment.h>
#include <lumbricus/errors/finer_solver.h>
#include <lumbricus/errors/hanging_functions.h>
#include <lumbricus/errors/shape_change.h>
#include <lumbricus/measures/section_measures.h>
#include <lumbricus/measures/segment_state.h>

#include <gtest/gtest.h>

#include "specimen.h"

using namespace lumbricus;

namespace
{
  const std::string body = R"(
subsection Geometry
  set Shape = segment chain
  subsection segment chain
    set Number of segments = 2
    set Wall layers        = wall
    set Wall layer thicknesses = 0.3
    set Cross-section      = quarter
  end
end
subsection Tissues
  subsection wall
    set Muscles = circular
    subsection Neo-Hooke
      set nu = 0.3
    end
  end
  subsection septum
    subsection Neo-Hooke
      set nu = 0.3
    end
  end
  subsection cap
    subsection Neo-Hooke
      set nu = 0.3
    end
  end
end
subsection Muscles
  subsection circular
    set Fibres         = circumferential
    set Active stretch = expression
    subsection expression
      set Formula = 1 - 0.2*t
    end
  end
end
subsection Mesh
  set Refine where      = if(x < 1, 1, 0)
  set Local refinements = 1
end
)";



  // The body and the same with eight cells in place of each.
  class Errors : public ::testing::Test
  {
  protected:
    Errors()
      : specimen(body)
      , large(*specimen.model)
      , solver([](auto &, auto &, const auto &, const auto &) {}, 1)
      , small(specimen.parameters,
              solver,
              specimen.timer,
              specimen.comm)
    {
      small.triangulation.copy_triangulation(large.triangulation);
      small.triangulation.refine_global(1);
      // The children fill their parents.
      small.space.set_finest_curved_level(0);
      small.number_unknowns();
      small.reinit();
      cells = std::make_unique<CutCells>(large.body,
                                         large.assembler.tangent().unknowns,
                                         small.body,
                                         small.assembler.tangent().unknowns);
    }

    // Noise in the free unknowns of a model.
    Vector
    noise(const ChainModel &of, const double seed) const
    {
      const auto &unknowns = of.assembler.tangent().unknowns;
      Vector      x;
      unknowns.reinit_vector(x);
      for (unsigned int k = 0; k < x.locally_owned_size(); ++k)
        if (!unknowns.is_constrained()[k])
          x.local_element(k) =
            std::sin(seed * (1. + x.get_partitioner()->local_to_global(k)));
      return x;
    }

    Specimen                  specimen;
    ChainModel               &large;
    FinerSolver               solver;
    ChainModel                small;
    std::unique_ptr<CutCells> cells;
  };



  TEST_F(Errors, RestrictionIsTheTransposedOfProlongation)
  {
    const Vector x = noise(large, 0.7), r = noise(small, 1.3);
    Vector       Px, PTr;
    cells->prolongate(Px, x);
    cells->restrict_to(PTr, r);
    const double left = Px * r, right = x * PTr;
    EXPECT_GT(std::abs(left), 1e-3);
    EXPECT_NEAR(left / right, 1., 1e-10);
  }



  TEST_F(Errors, StatesStayTheFunctionsTheyAre)
  {
    State state    = specimen.state;
    state.time     = 0.3;
    state.solution = specimen.random(0.01, 1);
    State finer    = small.space.zero_state(state.outline());
    cells->prolongate(state, finer);
    large.set_to(state);
    small.set_to(finer);
    const auto a = large.measure(state), b = small.measure(finer);
    for (unsigned int s = 0; s < a.segments.size(); ++s)
      {
        EXPECT_NEAR(b.segments[s].liquid_volume / a.segments[s].liquid_volume,
                    1.,
                    1e-10);
        EXPECT_NEAR(b.segments[s].wall_volume / a.segments[s].wall_volume,
                    1.,
                    1e-10);
        EXPECT_NEAR(b.measures[s].length / a.measures[s].length, 1., 1e-10);
      }
  }



  TEST_F(Errors, LinearisingSaysWhereACellIsFolded)
  {
    State state = specimen.state;
    EXPECT_TRUE(large.linearise_at(state));
    state.solution = specimen.random(10., 1);
    EXPECT_FALSE(large.linearise_at(state));
  }



  // How much a sum of products of numbers with factors changes along a way, by a
  // difference.
  template <typename Number>
  double
  change_along(ChainModel   &model,
               const State  &state,
               const Vector &way,
               const Number &number)
  {
    constexpr double h = 1e-4;
    double           values[2];
    for (const unsigned int ahead : {0, 1})
      {
        State moved = state;
        moved.solution.add(ahead == 1 ? h : -h, way);
        values[ahead] = 0.;
        const auto solve = model.measure(moved);
        for (unsigned int s = 0; s < solve.segments.size(); ++s)
          values[ahead] += number(solve, s);
      }
    return (values[1] - values[0]) / (2. * h);
  }



  TEST_F(Errors, DerivativesOfNumbersOfSegments)
  {
    State state    = specimen.state;
    state.solution = specimen.random(0.01, 1);
    large.set_to(state);
    const CellUnknowns &unknowns = large.assembler.tangent().unknowns;
    const auto          at       = large.space.with_ghosts(state.solution);
    Vector              way      = noise(large, 0.7);
    const auto          factor   = [](const unsigned int s) { return 1. + 2. * s; };
    const std::vector<double> none(2, 0.), factors{factor(0), factor(1)};

    Vector full = way;
    large.supports.constraints().distribute(full);
    const double lengths = change_along(
      large, state, full, [&](const auto &solve, const unsigned int s) {
        return factor(s) * solve.measures[s].length;
      });
    EXPECT_GT(std::abs(lengths), 1e-3);
    EXPECT_NEAR((section_derivative(large.body, unknowns, factors, none, at) * way) /
                  lengths,
                1.,
                1e-6);
    const double radii = change_along(
      large, state, full, [&](const auto &solve, const unsigned int s) {
        return factor(s) * solve.measures[s].mid_radius;
      });
    EXPECT_GT(std::abs(radii), 1e-3);
    EXPECT_NEAR((section_derivative(large.body, unknowns, none, factors, at) * way) /
                  radii,
                1.,
                1e-6);

    // Displacements do not matter to the pressure of a liquid that is hydrostatic.
    State at_rest = specimen.state;
    large.set_to(at_rest);
    for (unsigned int i = 0; i < unknowns.n_cells(); ++i)
      for (unsigned int k = 0; k < CellUnknowns::n_per_cell; ++k)
        if (k < CellUnknowns::pressure(0) ||
            k >= CellUnknowns::pressure(0) + MixedSpace::n_pressure_modes)
          full.local_element(unknowns.places(i)[k]) = 0.;
    const double pressures = change_along(
      large, at_rest, full, [&](const auto &solve, const unsigned int s) {
        return factor(s) * solve.segments[s].mean_pressure();
      });
    const auto at_zero = large.space.with_ghosts(at_rest.solution);
    const auto derivative = pressure_derivative(large.body,
                                                unknowns,
                                                large.references,
                                                factors,
                                                at_zero,
                                                at_rest.globals);
    EXPECT_GT(std::abs(pressures), 1e-3);
    EXPECT_NEAR(derivative.first * full / pressures, 1., 1e-6);
    full.update_ghost_values();
    const auto changes = pressure_changes(large.body,
                                          unknowns,
                                          large.references,
                                          at_zero,
                                          at_rest.globals,
                                          full,
                                          at_rest.globals);
    EXPECT_NEAR((factors[0] * changes[0] + factors[1] * changes[1]) / pressures,
                1.,
                1e-6);
  }



  TEST_F(Errors, ProductsOfLargeCellsAddUpToTheWhole)
  {
    // With the signs of a vector on itself nothing cancels.
    const Vector x     = noise(small, 0.4);
    double       sum   = 0.;
    for (const double of_cell : cells->products(x, x))
      {
        EXPECT_GT(of_cell, 0.);
        sum += of_cell;
      }
    EXPECT_NEAR(dealii::Utilities::MPI::sum(sum, specimen.comm) / (x * x), 1., 1e-12);
  }



  TEST_F(Errors, TheEnrichmentSeesFacesWithHangingNodes)
  {
    // A force on a node of small cells that hanging ones follow, which the large ones
    // do not have.
    small.linearise_at(small.rest_state());
    const Tangent         &tangent  = small.assembler.tangent();
    const CellUnknowns    &unknowns = tangent.unknowns;
    const FamilyFunctions  functions;
    const HangingFunctions hanging(small.body, unknowns, *cells, functions);
    Enrichment             enrichment(small.body, tangent, *cells);
    enrichment.factor();
    Vector force, x, r;
    unknowns.reinit_vector(force);
    x = r = force;
    std::vector<unsigned int> found;
    for (const OwnedCell cell : small.body.owned_cells())
      for (unsigned int k = 0; k < CellUnknowns::n_per_cell && !cell.is_liquid; ++k)
        {
          const unsigned int place = unknowns.places(cell.index)[k];
          if (found.size() < 3 && place < force.locally_owned_size() &&
              !unknowns.is_constrained(cell.index, k) && hanging.leads(place) &&
              !functions.is_of_large_cell(cells->child(cell.index), k))
            found.push_back(place);
        }
    // One rank after the other.
    const unsigned int n_ranks = dealii::Utilities::MPI::n_mpi_processes(specimen.comm);
    unsigned int n_found = dealii::Utilities::MPI::sum<unsigned int>(found.size(),
                                                                     specimen.comm);
    for (unsigned int i = 0; i < 3 * n_ranks; ++i)
      {
        const bool mine =
          i / 3 == dealii::Utilities::MPI::this_mpi_process(specimen.comm) &&
          i % 3 < found.size();
        force = 0.;
        x     = force;
        r     = force;
        if (mine)
          force.local_element(found[i % 3]) = 1.;
        enrichment.correct(x, force);
        tangent.vmult(r, x);
        if (mine)
          {
            // What is left of it is what volumes say, whose penalty is softer.
            EXPECT_GT(x.local_element(found[i % 3]), 0.);
            EXPECT_NEAR(r.local_element(found[i % 3]), 1., 0.2);
          }
      }
    EXPECT_GT(n_found, 0u);
  }



  TEST_F(Errors, ARotationStaysOneOnTheTrueShape)
  {
    // A displacement that was left at nodes which go elsewhere strained what was
    // stiff: an estimate had 17 times the error.
    ChainModel curved(specimen.parameters, solver, specimen.timer, specimen.comm);
    curved.triangulation.copy_triangulation(small.triangulation);
    curved.space.set_finest_curved_level(1);
    curved.number_unknowns();
    curved.reinit();
    const CellUnknowns &unknowns = curved.assembler.tangent().unknowns;
    const CutCells      to_curved(large.body,
                             large.assembler.tangent().unknowns,
                             curved.body,
                             unknowns);

    // u = A X with a rotation about the axis of the body and a stretch.
    dealii::Tensor<2, dim> A;
    A[0][0] = 0.1;
    A[1][1] = A[2][2] = std::cos(0.5) - 1.;
    A[1][2]           = -std::sin(0.5);
    A[2][1]           = std::sin(0.5);
    const auto displacement_of = [&A](const ChainModel &model) {
      State state = model.rest_state();
      std::vector<dealii::types::global_dof_index> indices(
        model.space.fe.n_dofs_per_cell());
      for (const OwnedCell cell : model.body.owned_cells())
        {
          cell.iterator->get_dof_indices(indices);
          for (unsigned int n = 0; n < MixedSpace::n_nodes; ++n)
            for (unsigned int c = 0; c < dim; ++c)
              {
                const auto i = indices[model.space.displacement_dof[c][n]];
                if (model.space.locally_owned.is_element(i))
                  state.solution(i) =
                    (A * dealii::Tensor<1, dim>(
                           model.shapes.node(cell.index, n)))[c];
              }
        }
      return state;
    };
    const State right   = displacement_of(curved);
    State       moved   = curved.rest_state();
    to_curved.prolongate(displacement_of(large), moved);
    Vector left = moved.solution;
    left -= right.solution;
    const double before = left.linfty_norm();
    follow_shape(large.body, curved.body, unknowns, to_curved, moved);
    left = moved.solution;
    left -= right.solution;
    EXPECT_GT(before, 1e-3);
    EXPECT_LT(left.linfty_norm(), 1e-12);
  }



  TEST_F(Errors, TheEnrichmentInvertsItsOwnMatrix)
  {
    // But for the penalty beside the bulk modulus, which is softer by far here.
    small.linearise_at(small.rest_state());
    const Tangent      &tangent  = small.assembler.tangent();
    const CellUnknowns &unknowns = tangent.unknowns;
    Enrichment          enrichment(small.body, tangent, *cells);
    enrichment.factor();

    Vector forces = noise(small, 0.9), x, r, again;
    unknowns.reinit_vector(x);
    r = again = x;
    const auto without_pressures = [&](Vector &v) {
      for (unsigned int i = 0; i < unknowns.n_cells(); ++i)
        for (unsigned int m = 0; m < MixedSpace::n_pressure_modes; ++m)
          v.local_element(unknowns.places(i)[CellUnknowns::pressure(m)]) = 0.;
    };
    without_pressures(forces);
    enrichment.correct(x, forces);
    tangent.vmult(r, x);
    enrichment.correct(again, r);
    again -= x;
    without_pressures(again);
    without_pressures(x);
    EXPECT_GT(x.l2_norm(), 0.);
    EXPECT_LT(again.l2_norm(), 0.05 * x.l2_norm());
  }
} // namespace
