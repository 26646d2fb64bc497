// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_continuation_continuation_h
#define lumbricus_continuation_continuation_h

#include <lumbricus/core/log.h>
#include <lumbricus/core/state.h>
#include <lumbricus/output/step_record.h>
#include <lumbricus/parameters/parameter_owner.h>

#include <map>
#include <string>

namespace lumbricus
{
  class ChainModel;
  class RunParameters;
  class RunWatch;

  /**
   * How a run goes on: it makes the next state out of the last one, both in
   * equilibrium,
   *
   *   r(u_n, t_n) = 0  ->  r(u_(n+1), t_(n+1)) = 0,
   *
   * and decides by itself what it prescribes of that: the time, or a length
   * along the path of all equilibria. All functions are collective.
   *
   * What a step needs to know of those before it is in the State, which is
   * copied to roll back, goes from mesh to mesh and is in checkpoints:
   * State::past are the ends of the last steps, and a NodalHistory is a field
   * of its own. The few numbers that are of the continuation alone are
   * numbers().
   */
  class Continuation : public ParameterOwner
  {
  public:
    /** Numbers by name; a name has no blanks. */
    using Numbers = std::map<std::string, double>;

    void
    declare_parameters(dealii::ParameterHandler & /*prm*/) override
    {}

    /** Take what is needed of the other parameters of the run, which have been
     * read and checked: once, before all that follows. */
    virtual void
    initialize(const RunParameters & /*parameters*/)
    {}

    /**
     * Before the first step, and before any file is changed, but not where a
     * case is only checked: find what steps will need. Throws ExcInput, unless
     * overridden where a muscle has HeldValues, which would never change.
     */
    virtual void
    open(const ChainModel &model);

    /**
     * Take step @p number from @p state, by ChainModel::solve() or a solve like
     * it, and write State::past of the new state. What is tried is told to
     * @p watch first (RunWatch::begin_step()), what the user is to know is
     * written to @p log.
     * @return what it took: number, time, size, n_cuts, relaxed, and a report
     * with one solve at least; the rest of it is set by the caller.
     * Throws ExcSolveFailed where no step leads on, with a message that says
     * why (diagnose() knows); @p state may then be anything.
     */
    virtual StepRecord
    advance(ChainModel        &model,
            State             &state,
            const unsigned int number,
            RunWatch          &watch,
            Log               &log) = 0;

    /** Whether the run ends at @p state: at 'Time/End', unless this says
     * something else. */
    virtual bool
    finished(const ChainModel &model, const State &state) const;

    /** The mesh was adapted to @p state, which was solved for again at its
     * time. Nothing goes on there as it did: forget the past. */
    virtual void
    adapted(State &state) const;

    /** Whether a state may have a time before that of the last one. */
    virtual bool
    time_may_go_back() const
    {
      return false;
    }

    /** What a checkpoint has to remember besides the State. */
    virtual Numbers
    numbers() const
    {
      return {};
    }

    /**
     * Go on with what numbers() of another run has returned, after
     * initialize(), or before it just to see if it can be.
     * @return whether it can; then only this is changed. They may come from a
     * file that somebody has made up, but are finite.
     */
    virtual bool
    set_numbers(const Numbers &numbers)
    {
      return numbers.empty();
    }

  protected:
    /** Whether both have all their names in common. */
    static bool
    has_same_names(const Numbers &a, const Numbers &b);
  };
} // namespace lumbricus

#endif
