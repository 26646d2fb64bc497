// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_continuation_path_equation_h
#define lumbricus_continuation_path_equation_h

#include <lumbricus/equilibrium/load_unknown.h>
#include <lumbricus/equilibrium/stability.h>
#include <lumbricus/output/step_record.h>
#include <lumbricus/program/chain_model.h>

namespace lumbricus
{
  /** An equation that says where on the path of equilibria of a model a step ends,
   * with the time as an unknown. */
  class PathEquation : public LoadUnknown
  {
  public:
    /** Of @p model, which is kept by reference. */
    explicit PathEquation(ChainModel &model);

    void
    set_loads(const LoadTime &t) override;

    /** A millionth of 'Time/First step'. */
    double
    difference() const override;

    /**
     * The state on the path at which the equation holds: Newton's method starts
     * at the displacements and pressures @p guess and the time @p t. Its past is
     * @p state, its report goes to @p step. Throws ExcNotConverged. Collective.
     */
    State
    solve(const State  &state,
          const Vector &guess,
          const double  t,
          StepRecord   &step);

    /** How stable the model is at @p state, on the path, against motions that keep the
     * equation. Throws ExcNotConverged. Collective. */
    Stability::Ends
    stability(const State &state);

  protected:
    /** 'Time/First step' [time]. */
    double
    unit() const;

    ChainModel &model; ///< whose path it is
  };
} // namespace lumbricus

#endif
