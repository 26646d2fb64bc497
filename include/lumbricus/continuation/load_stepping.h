// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_continuation_load_stepping_h
#define lumbricus_continuation_load_stepping_h

#include <lumbricus/parameters/parameter_owner.h>

namespace lumbricus
{
  /**
   * When a run ends, and how long its load steps are. A step that does not
   * converge is halved; steps that converge easily let the size grow again.
   * Times at which results are asked for are met exactly.
   */
  class LoadStepping : public ParameterOwner
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    void
    check_parameters() const override;

    /** Where the run ends [time]; it starts at 0. */
    double
    end_time() const;

    /** Whether @p time is the end. */
    bool
    finished(const double time) const;

    /** The size of the first step [time]. */
    double
    first_step() const;

    /** No step is longer than this [time]. */
    double
    largest_step() const;

    /** A step that is cut is not shorter than this [time]. */
    double
    smallest_step() const;

    /** The time that a step of size @p step goes to, from @p time: a little
     * more or less, where results are asked for or the end is. */
    double
    next_time(const double time, const double step) const;

    /** The size of the step wanted next, after one of size @p step that
     * converged; the first solve in it, before any reset, in this many Newton
     * iterations. */
    double
    step_after(const double       step,
               const unsigned int n_newton_iterations) const;

  private:
    double       end      = 1.;
    double       first    = 0.05;
    double       largest  = 0.05;
    double       smallest = 1e-4;
    double       interval = 0.;
    double       growth   = 1.5;
    unsigned int easy     = 6;
  };
} // namespace lumbricus

#endif
