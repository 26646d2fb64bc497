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

    /** Called after every solve, with which segments are reset then. */
    using Listener =
      std::function<void(const Solve &, const std::vector<bool> &)>;

    /** What one load step took. */
    struct Report
    {
      std::vector<Solve>        solves;   ///< in their order
      std::vector<unsigned int> n_resets; ///< per segment

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
      dealii::TimerOutput &timer;       ///< of what resets take
    };

    /** Solve @p model for the state at the time of @p state, coming from
     * @p state and beginning with @p guess, on which the result does not
     * depend. Throws ExcNotConverged. Collective. */
    Report
    solve(State &state, const Vector &guess, const Model &model) const;

    /** Call @p new_listener after every solve. */
    void
    report_to(const Listener &new_listener);

    /** Before a load step from @p state: relax the mesh inside the liquid where
     * it asks for it, which is a reset too. Collective. */
    LiquidMesh::Relaxation
    relax_mesh(State              &state,
               const Body         &body,
               const CellUnknowns &unknowns) const;

  private:
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
