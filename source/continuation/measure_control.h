// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_continuation_measure_control_h
#define lumbricus_continuation_measure_control_h

#include <lumbricus/continuation/continuation.h>
#include <lumbricus/geometry/segment_ranges.h>

#include <string>
#include <vector>

#include "branching.h"

namespace lumbricus
{
  class PathEquation;

  /**
   * Steps at whose ends a measure m > 0 of some segments is given, from what it is
   * to a target, and the load parameter t is what it takes:
   *
   *   r(u, g, t) = 0,   m(u)/m_0 = l,   l_(n+1) = l_n exp(+-h),
   *
   * where m_0 is that at rest. So t may turn on the way, but m may not.
   */
  class MeasureControl : public Continuation
  {
  public:
    /** By the measure @p measure, "length", in the section @p section of Path. */
    MeasureControl(const std::string &section, const std::string &measure);

    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    /** That the smallest step is not larger than the others. */
    void
    check_parameters() const override;

    /** Throws ExcInput where there is no such segment. */
    void
    initialize(const RunParameters &parameters) override;

    /** Throws ExcInput as check_needs_no_clock() and check() do. */
    void
    open(const ChainModel &model) override;

    StepRecord
    advance(ChainModel        &model,
            State             &state,
            const unsigned int number,
            RunWatch          &watch,
            Log               &log) override;

    /** At the target. */
    bool
    finished(const ChainModel &model, const State &state) const override;

    /** "given": the l of the last step, 0 before the first; "step_size": h of the
     * step wanted next; and those of Branching. */
    Numbers
    numbers() const override;

    /** Where the loads turn. */
    bool
    time_may_go_back() const override
    {
      return true;
    }

    bool
    set_numbers(const Numbers &numbers) override;

    /** The sum of m over the segments(), at @p relevant_solution, a ghosted vector.
     * Collective. */
    virtual double
    value(const ChainModel &model, const Vector &relevant_solution) const = 0;

    /** Its derivative by the free unknowns there. Collective. */
    virtual Vector
    derivative(const ChainModel &model,
               const Vector     &relevant_solution) const = 0;

  protected:
    /** Throws ExcInput where these segments of @p model have no such measure, or
     * one that no load can change; see refuse(). Collective. */
    virtual void
    check(const ChainModel &model) const = 0;

    /** Throw ExcInput, for segment @p segment, from zero, has what cannot be
     * given: @p why, as the end of a sentence about the segment. */
    [[noreturn]] void
    refuse(const unsigned int segment, const std::string &why) const;

    /** Whose measure it is, from zero. */
    const std::vector<unsigned int> &
    segments() const
    {
      return of_segments;
    }

  private:
    /** "length of segments 1, 3-5". */
    std::string
    name() const;

    /** "Path/length of a segment/Step". */
    std::string
    path(const std::string &entry) const;

    /** The l of @p solution. Collective. */
    double
    relative_value(const ChainModel &model, const Vector &solution) const;

    /** Time, displacements and pressures to begin with where l is to be @p next_l and
     * is @p l at @p state: as they went on from the state before. */
    State::Past
    predict(const ChainModel &model,
            const State      &state,
            const double      l,
            const double      next_l) const;

    /** Where the step from @p state to @p next, in which @p equation holds, has passed
     * a bifurcation: put a state of the other branch into @p next, and what is given
     * there. Throws ExcNotConverged. */
    void
    follow_a_branch(ChainModel   &model,
                    PathEquation &equation,
                    const State  &state,
                    State        &next,
                    StepRecord   &step,
                    Log          &log);

    /** Where the loads at the time @p to, which the next step takes, are beyond
     * those of the run, throw ExcSolveFailed. */
    void
    check_loads(const ChainModel &model,
                const double      l,
                const State      &state,
                const double      to) const;

    /** A step by @p change did not converge for the reason @p why: shorten the
     * next. Throws ExcSolveFailed. */
    void
    cut(const double       l,
        const double       change,
        const State       &state,
        const std::string &why,
        Log               &log);

    const std::string section, measure;

    std::string segment_list = "1";
    double      target       = 1.;
    double      largest      = 0.05;
    double      smallest     = 1e-4;

    std::vector<unsigned int> of_segments;

    double      given = 0.;
    double      size  = 0.; // 0: not known
    Branching   branch;
  };
} // namespace lumbricus

#endif
