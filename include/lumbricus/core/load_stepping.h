// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_core_load_stepping_h
#define lumbricus_core_load_stepping_h

#include <lumbricus/core/parameter_owner.h>

namespace lumbricus
{
  /**
   * The size of the load steps. A step that does not converge is halved; steps
   * that converge easily let the size grow again. Times at which results are
   * asked for are met exactly.
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

    /** A step that is cut is not shorter than this [time]. */
    double
    smallest_step() const;

    /** The time the next step goes to, from @p time. */
    double
    next_time(const double time) const;

    /** The step to next_time() converged; the first solve in it, before any
     * reset, in this many Newton iterations. */
    void
    accept(const unsigned int n_newton_iterations);

    /**
     * The step from @p time to @p next did not converge for the reason @p why:
     * halve it. Throws ExcSolveFailed where it would be shorter than the
     * shortest.
     */
    void
    cut(const double time, const double next, const std::string &why);

    /** The size of the step wanted next. */
    double
    step() const;

    /** Go on with this size. */
    void
    set_step(const double step);

  private:
    double       end      = 1.;
    double       first    = 0.05;
    double       largest  = 0.05;
    double       smallest = 1e-4;
    double       interval = 0.;
    double       growth   = 1.5;
    unsigned int easy     = 6;

    /** The step wanted next; zero before the first. */
    double size = 0.;
  };
} // namespace lumbricus

#endif
