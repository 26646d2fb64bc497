// SPDX-License-Identifier: LGPL-2.1-or-later
#include "finer_model.h"

#include <lumbricus/core/exceptions.h>
#include <lumbricus/discretization/state_beside.h>
#include <lumbricus/discretization/displacement_before.h>
#include <lumbricus/errors/shape_change.h>
#include <lumbricus/linear/bordered_system.h>
#include <lumbricus/measures/section_measures.h>
#include <lumbricus/measures/segment_state.h>

#include <iostream>
#include <limits>
#include <string>
#include <vector>

namespace lumbricus
{
  namespace
  {
    // Systems of the run's own mesh are solved to the square of this, so that an
    // estimate is the same on any number of ranks: twice, since one solve with more
    // iterations than the solver allows would make it give up what it is.
    constexpr double tolerance_of_corrections = 3e-5;

    // Of the system of the small cells: with more than these an estimate becomes
    // hardly better.
    constexpr unsigned int n_iterations = 4;



    // Solve with the tangent of a model and a border.
    void
    solve_on(ChainModel                &model,
             const Border              &border,
             Vector                    &x,
             std::vector<double>       &g,
             const Vector              &b,
             const std::vector<double> &c)
    {
      const BorderedTangent system(model.assembler.tangent(), border);
      const BorderedVector  right = bordered_vector(b, c);
      BorderedVector        left = right, sum = right, product = right;
      sum = 0.;
      for (unsigned int k = 0; k < 2; ++k)
        {
          Vector              dx = left.block(0);
          std::vector<double> dg;
          model.linear_solver.solve(dx,
                                    dg,
                                    left.block(0),
                                    globals_of(left),
                                    border,
                                    tolerance_of_corrections);
          sum += bordered_vector(dx, dg);
          system.vmult(product, sum);
          left = right;
          left -= product;
        }
      x = sum.block(0);
      g = globals_of(sum);
    }
  } // namespace



  FinerModel::FinerModel(ChainModel &model, const Shape shape)
    : model(model)
    , shape(shape)
    , timer(std::cout,
            dealii::TimerOutput::never,
            dealii::TimerOutput::wall_times)
    , solver(
        [&model](Vector                    &x,
                 std::vector<double>       &g,
                 const Vector              &b,
                 const std::vector<double> &c) {
          solve_on(
            model, model.equilibrium.linearised_border(), x, g, b, c);
        },
        n_iterations)
    , finer(model.parameters, solver, timer, model.space.communicator())
  {
    finer.triangulation.copy_triangulation(model.triangulation);
    finer.triangulation.refine_global(1);
    finer.space.set_finest_curved_level(
      model.parameters.mesh_refinement.n_global_refinements() +
      (shape == Shape::true_one ? 1 : 0));
    finer.number_unknowns();
    finer.reinit();
    cells = std::make_unique<CutCells>(model.body,
                                       model.assembler.tangent().unknowns,
                                       finer.body,
                                       finer.assembler.tangent().unknowns);
    solver.set_cells(finer.body, *cells);
  }



  std::vector<SegmentError>
  FinerModel::errors(const State &state, const ResetIteration::Solve &solve)
  {
    model.linearise_at(state);
    const State alone = without_state_beside(state);
    prolongated       = finer.space.zero_state(alone.outline());
    cells->prolongate(alone, prolongated);
    // What else is remembered as a displacement stays where it was: then so does
    // this one.
    if (shape == Shape::true_one &&
        (!model.body.anatomy.has_liquid() || model.liquid_flows()) &&
        prolongated.histories.count(displacement_before.name()) == 0)
      follow_shape(model.body,
                   finer.body,
                   finer.assembler.tangent().unknowns,
                   *cells,
                   prolongated);
    State on_finer = prolongated;
    AssertThrow(finer.linearise_at(on_finer),
                ExcNotConverged("On a finer mesh " +
                                finer.equilibrium.locate_trouble(
                                  {on_finer.solution, on_finer.globals})));

    Unknowns increment{on_finer.solution, on_finer.globals};
    finer.equilibrium.solve(increment, 0.);
    on_finer.solution += increment.solution;
    for (const auto &[name, values] : increment.globals)
      for (unsigned int k = 0; k < values.size(); ++k)
        on_finer.globals.at(name)[k] += values[k];

    const CellUnknowns &unknowns = finer.assembler.tangent().unknowns;
    Vector              change;
    unknowns.reinit_vector(change);
    change.copy_locally_owned_data_from(increment.solution);
    change.update_ghost_values();
    const auto pressures =
      pressure_changes(finer.body,
                       unknowns,
                       finer.references,
                       finer.space.with_ghosts(prolongated.solution),
                       prolongated.globals,
                       change,
                       increment.globals);
    const auto measures =
      section_measures(finer.body, finer.space.with_ghosts(on_finer.solution));
    // Where the skin hangs on to something the body is where all steps before
    // have brought it, which one increment does not know.
    const bool knows_place = model.surface_terms.histories().empty();
    std::vector<SegmentError> errors;
    for (unsigned int s = 0; s < measures.size(); ++s)
      errors.push_back({measures[s].length - solve.measures[s].length,
                        measures[s].mid_radius - solve.measures[s].mid_radius,
                        pressures[s],
                        knows_place ?
                          measures[s].middle() - solve.measures[s].middle() :
                          std::numeric_limits<double>::quiet_NaN()});
    return errors;
  }



  std::vector<double>
  FinerModel::contributions(const std::vector<SegmentError> &f)
  {
    std::vector<double> of_lengths, of_radii, of_pressures;
    for (const SegmentError &of_segment : f)
      {
        of_lengths.push_back(of_segment.length);
        of_radii.push_back(of_segment.mid_radius);
        of_pressures.push_back(of_segment.pressure);
      }
    const CellUnknowns &unknowns = finer.assembler.tangent().unknowns;
    const Vector   solution = finer.space.with_ghosts(prolongated.solution);
    auto           j        = pressure_derivative(finer.body,
                                 unknowns,
                                 finer.references,
                                 of_pressures,
                                 solution,
                                 prolongated.globals);
    j.first += section_derivative(
      finer.body, unknowns, of_lengths, of_radii, solution);

    const Border &border = finer.equilibrium.linearised_border();
    const Border  turned = transposed(model.equilibrium.linearised_border());
    return solver.contributions(
      finer.equilibrium.right_hand_side(),
      j.first,
      border.read(j.second),
      border,
      [&](Vector                    &x,
          std::vector<double>       &g,
          const Vector              &b,
          const std::vector<double> &c) {
        solve_on(model, turned, x, g, b, c);
      });
  }
} // namespace lumbricus
