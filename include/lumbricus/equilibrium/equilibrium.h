// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_equilibrium_equilibrium_h
#define lumbricus_equilibrium_equilibrium_h

#include <lumbricus/discretization/assembler.h>
#include <lumbricus/discretization/border.h>
#include <lumbricus/equilibrium/load_unknown.h>
#include <lumbricus/equilibrium/newton.h>
#include <lumbricus/linear/linear_solver.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/timer.h>

#include <deque>
#include <vector>

namespace lumbricus
{
  /**
   * Equilibrium of the body at a time, with the reference map as it is: the
   * assembler, what borders it, and the linear solver as Newton's method sees
   * them.
   */
  class Equilibrium : public NonlinearProblem
  {
  public:
    /** All of these are kept by reference; call reinit() first. */
    Equilibrium(const Body          &body,
                Assembler           &assembler,
                SurfaceTerms        &surface_terms,
                Supports            &supports,
                LinearSolver        &linear_solver,
                dealii::TimerOutput &timer);

    /** After every change of the mesh. */
    void
    reinit();

    /** From now on these border it, in this order; none at first. Kept by
     * reference. One that does so for a single step, as a Continuation may,
     * takes itself and its unknowns away again. */
    void
    set_borders(const std::vector<BorderSource *> &new_sources);

    /** Those of set_borders(). */
    const std::vector<BorderSource *> &
    borders() const;

    /** Solve for the time too, which is then among the global unknowns, by the
     * name of LoadUnknown and last; null: no longer. Kept by reference. */
    void
    set_load_unknown(LoadUnknown *new_load);

    /** The right-hand side -r of linearise(), with what the borders add. */
    const Vector &
    right_hand_side() const;

    /** What they make of the state that was linearised last. */
    const Border &
    linearised_border() const
    {
      return border;
    }

    /** That of set_time(). */
    const LoadTime &
    load_time() const
    {
      return time;
    }

    /** All global unknowns, with their values at rest. */
    Globals
    globals_at_rest() const;

    /** Set the time, and what @p solution lacks of the displacements prescribed
     * then. start_from() has to follow. */
    void
    set_time(const LoadTime &t, const Vector &solution);

    /** Let the linear solver start anew, as it does after a restart. */
    void
    forget_factors();

    /** Make @p way an increment that the constraints allow, with what is still
     * missing of what is prescribed. Collective. */
    void
    constrain(Vector &way) const;

    /** Where liquid slips along the wall, count the slip from @p solution:
     * before each solve, and before linearise() without one. */
    void
    start_from(const Vector &solution);

    /**
     * Whether a node is farther from where it was than the body at rest is
     * long, apart from what all nodes move on the average. A load step that
     * does this has found another equilibrium, to which nothing leads.
     */
    bool
    leaps(const Vector &from, const Vector &to) const;

    Residual
    residual(const Unknowns &x) override;

    bool
    linearise(const Unknowns &x) override;

    void
    solve(Unknowns &dx, const double tolerance) override;

    double
    largest_linear_tolerance() const override;

    double
    increment_size(const Vector &dx) const override;

    double
    largest_step(const Unknowns &x, const Unknowns &dx) override;

    bool
    increments_prescribed() const override;

    void
    increments_taken() override;

    std::string
    locate_trouble(const Unknowns &x) override;

  private:
    /** After every change of the mesh or of what constrains which unknown. */
    void
    reinit_solvers();

    /** The border that all sources make at @p x; what it adds to the residual
     * of the owned unknowns is added to @p residual; see BorderSource::border().
     */
    Border
    border_at(const Unknowns &x, Tangent *tangent, Vector &residual) const;

    /** Take the loads at the time that is among the unknowns of @p x, where it is
     * one. */
    void
    take_loads(const Unknowns &x);

    /** Let the unknown time follow the unknowns of @p all, which is at @p x; with
     * its column, row and corner if they are there. */
    void
    append_load(const Unknowns &x, const bool with_tangent, Border &all);

    /** Whether there are global unknowns. */
    bool
    is_bordered() const
    {
      return !sources.empty() || load != nullptr;
    }

    /** Let the constraints be those at @p x, where they follow it. */
    void
    follow(const Vector &x);

    const Body           body;
    Assembler           &assembler;
    SurfaceTerms        &surface_terms;
    Supports            &supports;
    LinearSolver        &linear_solver;
    dealii::TimerOutput &timer;

    LoadTime          time;
    bool              prescribed_is_due = false;
    double            body_volume       = 0.;
    double            length            = 1.;
    double            least_force       = 0.;
    double            extent            = 1.; // in lengths
    /** Of the owned unknowns: a component of u, or dim for p. */
    std::vector<unsigned char> component;
    Vector                     r;
    /** Where slip is counted from. */
    Vector start;
    /** The last two solutions that were linearised at, where something may
     * slide. */
    std::deque<Vector> linearised;

    std::vector<BorderSource *> sources;
    LoadUnknown                *load = nullptr;
    /** That of linearise(), and the right-hand side with what it adds. */
    Border border;
    Vector rhs;
  };
} // namespace lumbricus

#endif
