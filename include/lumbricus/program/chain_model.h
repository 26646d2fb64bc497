// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_chain_model_h
#define lumbricus_program_chain_model_h

#include <lumbricus/cavities/cavities.h>
#include <lumbricus/checkpoint/checkpoint.h>
#include <lumbricus/discretization/assembler.h>
#include <lumbricus/equilibrium/equilibrium.h>
#include <lumbricus/measures/body_motion.h>
#include <lumbricus/measures/contact_state.h>
#include <lumbricus/equilibrium/stability.h>
#include <lumbricus/measures/external_forces.h>
#include <lumbricus/measures/step_work.h>
#include <lumbricus/program/run_parameters.h>

#include <deal.II/base/timer.h>
#include <deal.II/distributed/tria.h>

#include <optional>
#include <vector>

namespace lumbricus
{
  /**
   * The body as a discrete problem: the mesh and everything that lives on it,
   * from the unknowns to the equilibrium, in the order in which each needs the
   * ones before it.
   */
  class ChainModel
  {
  public:
    /** Without a mesh, see create(). All of these are kept by reference; the
     * parameters have been read and checked. */
    ChainModel(RunParameters       &parameters,
               dealii::TimerOutput &timer,
               const MPI_Comm       comm);

    /** Without a mesh, for a model beside that of a run, with a solver of its
     * own. */
    ChainModel(RunParameters       &parameters,
               LinearSolver        &linear_solver,
               dealii::TimerOutput &timer,
               const MPI_Comm       comm);

    /** Make the mesh, that of @p checkpoint where there is one, and all that
     * lives on it. Throws ExcInput. Collective. */
    void
    create(const Checkpoint *checkpoint);

    /** Number the unknowns, after every change of the mesh. Collective. */
    void
    number_unknowns();

    /** Make all else that lives on the mesh, after that. Throws ExcInput.
     * Collective. */
    void
    reinit();

    /** A state of rest at time zero, with all the histories that this run
     * has. */
    State
    rest_state() const;

    /** The order of accuracy of load steps: 2 where the state remembers nothing from
     * step to step but what viscous branches do, 1 where it remembers more, and
     * nothing where how long they are makes no difference. */
    std::optional<unsigned int>
    order_of_steps() const;

    /** Whether liquid flows while Newton's method goes on, see
     * ResetIteration::lets_flow(). */
    bool
    liquid_flows() const;

    /** Make this the model of @p state under the loads at @p t, ready to be
     * linearised there. Collective. */
    void
    set_to(const State &state, const LoadTime &t);

    /** Make this the model of @p state under the loads at its time. */
    void
    set_to(const State &state);

    /**
     * Find the equilibrium at the time of @p state with a hydrostatic liquid,
     * from @p state on. Throws ExcNotConverged, with @p state left anywhere.
     * Collective.
     */
    ResetIteration::Report
    solve(State &state);

    /** What @p n more resets of all liquid, or a few more than that, make of
     * @p state, which solve() has found: its first solve is that of the state as
     * it is. Leaves the model at them. Throws ExcNotConverged. Collective. */
    ResetIteration::Report
    reset_again(const State &state, const unsigned int n);

    /** The forces of all loads and supports at @p state, which solve() has
     * found. Collective. */
    std::vector<ExternalForce>
    forces_on_body(const State &state);

    /** Where energy comes from and goes between the ends @p a and @p b of two load
     * steps, where solve() has found the last one; before end_step().
     * Collective. */
    StepWork
    work_of_step(const State &a, const State &b);

    /** See lumbricus::stored_energy(), at @p state, which solve() has found.
     * Collective. */
    double
    stored_energy(const State &state) const;

    /** What obstacles do to each segment at @p state, before end_step().
     * Collective. */
    std::vector<ContactState>
    contacts_of_body(const State &state);

    /** Where the body is at @p state, without a speed. Collective. */
    BodyMotion
    motion_of_body(const State &state);

    /** The load step that has led to @p state is complete: let it remember what
     * it has to. Collective. */
    void
    end_step(State &state) const;

    /** Find the equilibrium as solve(state) does, with the loads taken at @p t,
     * whatever the time of @p state, and with Newton's method beginning with
     * @p guess. */
    ResetIteration::Report
    solve(State &state, const LoadTime &t, const Vector &guess);

    /** Before a load step from @p state: see ResetIteration::relax_mesh(). */
    LiquidMesh::Relaxation
    relax_liquid_mesh(State &state);

    /** Linearise at @p state, as Newton's method does: where a liquid flows
     * there, it does so here, and points that stick make the tangent what it is.
     * @return whether no cell is folded. Collective. */
    bool
    linearise_at(const State &state);

    /** What @p state is like, with set_to() or solve() there before. Collective. */
    ResetIteration::Solve
    measure(const State &state) const;

    /** How stable the body is as the equilibrium was linearised last. Keeps this by
     * reference. */
    Stability
    stability() const;

    /** Between which materials liquid slips along the wall. */
    IsSlipInterface
    is_slip_interface() const;

    /** What was asked for, and the objects it made. */
    RunParameters &parameters;
    /** What solves for increments. */
    LinearSolver &linear_solver;
    /** Where time goes. */
    dealii::TimerOutput &timer;

    ParallelMesh   triangulation; ///< the mesh at rest
    MixedSpace     space;         ///< the unknowns on it
    ShapeCache     shapes;        ///< their shape functions
    const Body     body;          ///< space, shapes and the anatomy
    ReferenceField references;    ///< fibres, G and J_v at all points
    Supports       supports;      ///< the constraints
    SurfaceTerms   surface_terms; ///< tractions, and what the skin remembers
    VolumeTerms    volume_terms;  ///< body forces
    LiquidWeight   liquid_weight; ///< those on liquids
    Assembler      assembler;     ///< residual and tangent
    Cavities       cavities;      ///< chambers without cells
    Equilibrium    equilibrium;   ///< all that Newton's method sees

  private:
    // All that knows of a state and a time but equilibrium.
    void
    set_parts_to(const State &state, const LoadTime &t);

    // The forces at a state, whose work is that along a displacement.
    std::vector<ExternalForce>
    forces_on_body(const StateWithMaps &at, const Vector *way);

    const ResetIteration::Model reset_model;
  };
} // namespace lumbricus

#endif
