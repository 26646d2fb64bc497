// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_equilibrium_reset_iteration_h
#define lumbricus_equilibrium_reset_iteration_h

#include <lumbricus/equilibrium/equilibrium.h>
#include <lumbricus/equilibrium/liquid_mesh.h>
#include <lumbricus/measures/section_measures.h>
#include <lumbricus/measures/segment_state.h>

#include <functional>
#include <vector>

namespace lumbricus
{
  /**
   * The rubber-fluid reset (paper, "Coupling of liquid filling and elastic
   * membrane"): solve; where a segment's liquid diverges from the hydrostatic
   * state, make its present shape the stress-free one; solve again, until
   * every segment is hydrostatic. The solid keeps its stress.
   *
   * The state that this leads to is found at once where the liquid flows
   * (ReferencePoint::flows): its shape is the stress-free one in every iteration
   * of Newton's method, and what is reset after it is the shape of equilibrium.
   */
  class ResetIteration : public ParameterOwner
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    /** What there is to say of one solve: the first of a load step, or one
     * after a reset. All but the first is per segment. */
    struct Solve
    {
      std::vector<NewtonIteration> newton;     ///< all iterations
      std::vector<SegmentState>    segments;   ///< volumes, pressure
      std::vector<SectionMeasures> measures;   ///< length, radius
      std::vector<MeshQuality>     qualities;  ///< of the deformed cells
      std::vector<double>          divergence; ///< eta
    };

    /** Whether a reset forgets by how much the volume has changed, so that it
     * matters how often there is one. */
    bool
    forgets_volume() const
    {
      return mode == "full";
    }

    /** The same, but for at least @p n resets of all liquid in one load step. */
    ResetIteration
    with_least(const unsigned int n) const;

    /** Called after every solve, with which segments are reset then. */
    using Listener =
      std::function<void(const Solve &, const std::vector<bool> &)>;

    /** What one load step took. */
    struct Report
    {
      std::vector<Solve>        solves;   ///< in their order
      std::vector<unsigned int> n_resets; ///< per segment
      /** Segments inside whose liquid the mesh was relaxed; empty for none. */
      std::vector<bool> relaxed;

      /** Newton iterations of all solves. */
      unsigned int
      n_newton_iterations() const;
    };

    /** What is solved and reset, all by reference. */
    struct Model
    {
      Equilibrium         &equilibrium; ///< of the body under its loads
      const Newton        &newton;      ///< solves it
      SurfaceTerms        &surface;     ///< what is augmented
      ReferenceField      &references;  ///< what a reset changes
      LiquidWeight        &weight;      ///< of liquids, in what is measured
      const Body          &body;        ///< with the liquid
      const CellUnknowns  &unknowns;    ///< on its cells
      dealii::TimerOutput &timer;       ///< of what resets take
      const bool           slips; ///< the liquid does, along the wall
    };

    /** Solve @p model for the state at the time of @p state, coming from
     * @p state and beginning with @p guess, on which the result does not
     * depend. Throws ExcNotConverged. Collective. */
    Report
    solve(State &state, const Vector &guess, const Model &model) const;

    /** Call @p new_listener after every solve. */
    void
    report_to(const Listener &new_listener);

    /** Before a load step from @p state, unless its solve() does so in the end:
     * relax the mesh inside the liquid where it asks for it, which is a reset
     * too. Collective. */
    LiquidMesh::Relaxation
    relax_mesh(State &state, const Model &model) const;

    /** Whether the liquid flows while Newton's method goes on, so that it is
     * hydrostatic after one solve. Collective. */
    bool
    lets_flow(const Model &model) const;

    /** Say in @p solve what @p state is like. Collective. */
    void
    measure(const State &state, const Model &model, Solve &solve) const;

  private:

    /** At the end of a load step in which the liquid flowed: put the nodes inside
     * it where they belong. */
    void
    settle(State &state, const Model &model, Report &report) const;

    /** Make the present shape of the liquid stress-free in some segments. */
    void
    reset(State                   &state,
          const std::vector<bool> &in_segment,
          const Body              &body) const;

    /** Throw ExcNotConverged where segments that diverge do so more and more,
     * or there have been as many resets as there may be. */
    void
    check_progress(const std::vector<Solve> &solves,
                   const std::vector<bool>  &diverges) const;

    std::string  every          = "iteration";
    std::string  mode           = "isochoric";
    double       tolerance      = 1e-3;
    unsigned int least          = 0;
    unsigned int limit          = 40;
    double       pressure_floor = 1e-6;
    LiquidMesh   liquid_mesh;
    Listener     listener;
  };
} // namespace lumbricus

#endif
