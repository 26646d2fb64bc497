// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/adaptivity/cell_cost.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/discretization/displacement_before.h>
#include <lumbricus/discretization/surface_scales.h>
#include <lumbricus/discretization/viscous_memory.h>
#include <lumbricus/program/chain_model.h>

#include "contact_check.h"
#include "load_balance.h"
#include "piston_check.h"

namespace lumbricus
{
  ChainModel::ChainModel(RunParameters       &parameters,
                         dealii::TimerOutput &timer,
                         const MPI_Comm       comm)
    : ChainModel(parameters,
                 *parameters.linear_solver.get(),
                 timer,
                 comm)
  {}



  ChainModel::ChainModel(RunParameters       &parameters,
                         LinearSolver        &linear_solver,
                         dealii::TimerOutput &timer,
                         const MPI_Comm       comm)
    : parameters(parameters)
    , linear_solver(linear_solver)
    , timer(timer)
    , triangulation(comm)
    , space(triangulation)
    , shapes(space)
    , body(space, shapes, parameters.anatomy)
    , references(body)
    , supports(space,
               parameters.anatomy,
               parameters.interface_coupling,
               parameters.boundary_conditions)
    , surface_terms(body, parameters.boundary_conditions)
    , volume_terms(body, parameters.body_forces)
    , liquid_weight(body,
                    parameters.body_forces,
                    [&parameters](const unsigned int segment) {
                      return parameters.density_in_chamber(segment);
                    })
    , assembler(body,
                surface_terms,
                volume_terms,
                liquid_weight,
                references,
                supports)
    , cavities(body,
               assembler.tangent().unknowns,
               parameters.cavity_contents,
               liquid_weight)
    , equilibrium(body,
                  assembler,
                  surface_terms,
                  supports,
                  linear_solver,
                  timer)
    , reset_model{equilibrium,
                  parameters.newton,
                  surface_terms,
                  references,
                  liquid_weight,
                  body,
                  assembler.tangent().unknowns,
                  timer,
                  parameters.interface_coupling.slips()}
  {
    triangulation.signals.weight.connect(
      [slips = is_slip_interface()](const ParallelMesh::cell_iterator &cell,
                                    const auto /*status*/) {
        return cell_cost(cell, slips);
      });
  }



  void
  ChainModel::create(const Checkpoint *checkpoint)
  {
    parameters.anatomy.geometry().create_coarse_mesh(triangulation);
    if (checkpoint != nullptr)
      checkpoint->refine(triangulation);
    else
      parameters.mesh_refinement.refine(triangulation, is_slip_interface());
    space.set_finest_curved_level(
      parameters.mesh_refinement.n_global_refinements());
    number_unknowns();
    parameters.boundary_conditions.set_scales(surface_scales(body));
    reinit();
    parameters.try_expressions(triangulation);
    const auto times = parameters.times_to_try();
    parameters.symmetry_check.check(space,
                                    parameters.anatomy,
                                    parameters.boundary_conditions,
                                    parameters.body_forces,
                                    times);
    check_pistons(body, supports, times);
    liquid_weight.check_pistons(times);
    check_contacts(body,
                   parameters.boundary_conditions,
                   parameters.body_forces,
                   supports,
                   times);
    check_load_balance(body,
                       parameters.boundary_conditions,
                       parameters.body_forces,
                       liquid_weight,
                       supports,
                       times);
    parameters.follow_loads(triangulation);
  }



  void
  ChainModel::number_unknowns()
  {
    space.distribute_dofs(
      parameters.interface_coupling.slips() ?
        MixedSpace::Separate([this](const dealii::types::material_id id) {
          return parameters.anatomy.is_liquid(Region::of(id).tissue);
        }) :
        MixedSpace::Separate());
  }



  void
  ChainModel::reinit()
  {
    shapes.reinit();
    references.reinit();
    supports.reinit();
    liquid_weight.reinit();
    cavities.reinit();
    if (cavities.any())
      equilibrium.set_borders({&cavities});
    equilibrium.reinit();
  }



  State
  ChainModel::rest_state() const
  {
    StateOutline outline = space.initial_state().outline();
    outline.histories.merge(surface_terms.histories());
    if (way_counts(parameters.anatomy))
      outline.histories.insert(displacement_before.name());
    outline.histories.merge(histories_of_branches(parameters.anatomy));
    outline.globals = equilibrium.globals_at_rest();
    State state = space.zero_state(outline);
    surface_terms.end_step(state);
    return state;
  }



  std::optional<unsigned int>
  ChainModel::order_of_steps() const
  {
    const Anatomy &anatomy = parameters.anatomy;
    if (!surface_terms.histories().empty() || muscles_feel_speed(anatomy) ||
        cavities.something_flows() || parameters.interface_coupling.slips() ||
        (anatomy.has_liquid() && parameters.reset_iteration.forgets_volume()))
      return 1;
    if (anatomy.n_viscous_branches() > 0)
      return 2;
    return {};
  }



  bool
  ChainModel::liquid_flows() const
  {
    return parameters.reset_iteration.lets_flow(reset_model);
  }



  void
  ChainModel::set_parts_to(const State &state, const LoadTime &t)
  {
    references.update(state, t);
    surface_terms.set_to(state);
    cavities.set_to(state);
    liquid_weight.set_time(t);
  }



  void
  ChainModel::set_to(const State &state, const LoadTime &t)
  {
    set_parts_to(state, t);
    equilibrium.set_time(t, state.solution);
    equilibrium.start_from(state.solution);
  }



  void
  ChainModel::set_to(const State &state)
  {
    set_to(state, state.time);
  }



  ResetIteration::Report
  ChainModel::solve(State &state)
  {
    const Vector guess = state.solution;
    return solve(state, state.time, guess);
  }



  ResetIteration::Report
  ChainModel::solve(State &state, const LoadTime &t, const Vector &guess)
  {
    set_parts_to(state, t);
    parameters.try_loads(triangulation, {t.to()});
    equilibrium.set_time(t, guess);
    const Vector start = state.solution;
    const auto   report =
      parameters.reset_iteration.solve(state, guess, reset_model);
    AssertThrow(!equilibrium.leaps(start, state.solution),
                ExcNotConverged(
                  "The body has moved by more than its own length "
                  "within the step: this is another equilibrium, "
                  "to which nothing leads"));
    return report;
  }



  ResetIteration::Report
  ChainModel::reset_again(const State &state, const unsigned int n)
  {
    set_to(state);
    State after = state;
    return parameters.reset_iteration.with_least(n).solve(after,
                                                          state.solution,
                                                          reset_model);
  }



  std::vector<ExternalForce>
  ChainModel::forces_on_body(const State &state)
  {
    dealii::TimerOutput::Scope scope(timer, "reactions");
    return forces_on_body({state, references}, nullptr);
  }



  std::vector<ExternalForce>
  ChainModel::forces_on_body(const StateWithMaps &at, const Vector *way)
  {
    surface_terms.set_to(at.state);
    liquid_weight.set_time(at.state.time);
    return external_forces(body,
                           parameters.boundary_conditions,
                           surface_terms,
                           parameters.body_forces,
                           volume_terms,
                           liquid_weight,
                           at.references,
                           supports,
                           at.state.solution,
                           at.state.globals,
                           at.state.time,
                           way);
  }



  StepWork
  ChainModel::work_of_step(const State &a, const State &b)
  {
    dealii::TimerOutput::Scope scope(timer, "reactions");
    const BoundaryConditions  &conditions = parameters.boundary_conditions;
    ReferenceField             maps_of_a  = references;
    maps_of_a.update(a);
    Vector way = b.solution;
    way -= a.solution;

    StepWork work;
    work.stored      = lumbricus::stored_energy(body, references, b);
    work.stored_more = work.stored - lumbricus::stored_energy(body, maps_of_a, a);
    work.muscles     = work_of_muscles(body, {a, maps_of_a}, {b, references});
    work.viscosity   = work_of_viscosity(body, a, {b, references});
    work.friction    = work_of_friction(body, conditions, surface_terms, a, b);
    work.loads       = forces_on_body({a, maps_of_a}, &way);
    const auto at_b  = forces_on_body({b, references}, &way);
    const bool all_at_b = muscles_feel_speed(parameters.anatomy);
    for (unsigned int i = 0; i < at_b.size(); ++i)
      {
        // At the end of a step nothing knows how fast it was: neither a term nor
        // the muscles that a support holds.
        const auto *term = i < conditions.n_conditions() ?
                             conditions.condition(i).surface_term() :
                             nullptr;
        const double part =
          all_at_b || (term != nullptr && term->depends_on_rate()) ? 1. : 0.5;
        work.loads[i].work =
          (1. - part) * work.loads[i].work + part * at_b[i].work;
      }
    return work;
  }



  double
  ChainModel::stored_energy(const State &state) const
  {
    return lumbricus::stored_energy(body, references, state);
  }



  std::vector<ContactState>
  ChainModel::contacts_of_body(const State &state)
  {
    dealii::TimerOutput::Scope scope(timer, "output");
    surface_terms.set_to(state);
    return contact_states(body,
                          parameters.boundary_conditions,
                          surface_terms,
                          state.solution,
                          state.time);
  }



  BodyMotion
  ChainModel::motion_of_body(const State &state)
  {
    dealii::TimerOutput::Scope scope(timer, "output");
    return body_motion(body,
                       parameters.boundary_conditions,
                       liquid_weight,
                       state.solution);
  }



  void
  ChainModel::end_step(State &state) const
  {
    surface_terms.end_step(state);
    cavities.end_step(state);
    remember_branches(body, state); // from where the body was
    remember_displacement(body, state);
    state.last_time = state.time;
  }



  LiquidMesh::Relaxation
  ChainModel::relax_liquid_mesh(State &state)
  {
    dealii::TimerOutput::Scope scope(timer, "liquid's mesh");
    return parameters.reset_iteration.relax_mesh(state, reset_model);
  }



  bool
  ChainModel::linearise_at(const State &state)
  {
    const Unknowns x{state.solution, state.globals};
    set_to(state);
    references.let_liquid_flow(liquid_flows());
    if (surface_terms.may_slide())
      equilibrium.residual(x);
    const bool valid = equilibrium.linearise(x);
    references.let_liquid_flow(false);
    return valid;
  }



  ResetIteration::Solve
  ChainModel::measure(const State &state) const
  {
    ResetIteration::Solve solve;
    parameters.reset_iteration.measure(state, reset_model, solve);
    return solve;
  }



  Stability
  ChainModel::stability() const
  {
    return Stability(body,
                     assembler.tangent(),
                     equilibrium.linearised_border(),
                     linear_solver);
  }



  IsSlipInterface
  ChainModel::is_slip_interface() const
  {
    const bool  slips   = parameters.interface_coupling.slips();
    const auto &anatomy = parameters.anatomy;
    return [slips, &anatomy](const dealii::types::material_id one_side,
                             const dealii::types::material_id other_side) {
      return slips && anatomy.is_liquid(Region::of(one_side).tissue) !=
                        anatomy.is_liquid(Region::of(other_side).tissue);
    };
  }
} // namespace lumbricus
