// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_double_steps_h
#define lumbricus_program_double_steps_h

#include <lumbricus/core/log.h>
#include <lumbricus/errors/segment_error.h>
#include <lumbricus/program/chain_model.h>

#include <optional>
#include <vector>

namespace lumbricus
{
  /**
   * The same run in steps about twice as long, whose state goes beside that of the run
   * (put_beside()): what its numbers lack says what those of the run lack. Where
   * steps h of the run make a step H = sum h, and what steps remember is of order
   * q, errors grow by c sum h^(q+1) and by c H^(q+1), so that
   *
   *   e = (J - J_double) sum h^(q+1) / sum (H^(q+1) - h^(q+1)),
   *
   * with the sums over the run: (J - J_double)/(2^q - 1) for steps of one length.
   * A long step ends with the first step of the run at which that quotient would be
   * near this for it alone, so that no short step has to be one of a pair.
   */
  class DoubleSteps
  {
  public:
    /** For @p model, which is kept by reference; to be asked for nothing where they are
     * not @p wanted. */
    DoubleSteps(ChainModel &model, const bool wanted);

    /** Begin beside @p state, where the run begins. Collective. */
    void
    begin(State &state) const;

    /** Throw ExcInput where @p checkpoint, of which the run that begins at @p state is
     * to go on, has long steps and this run has none, or the other way round. */
    void
    check(const Checkpoint &checkpoint, const State &state) const;

    /**
     * The errors of the numbers of all segments at @p state, which ends a load step
     * and for which the model has found @p solve, before ChainModel::end_step(): none
     * where no long step ends there, NaN from where the long steps do not
     * converge, which @p log says. Changes what is beside @p state. Collective.
     */
    std::vector<SegmentError>
    errors(State &state, const ResetIteration::Solve &solve, Log &log);

    /** What there is to say before a run. */
    std::string
    note() const;

  private:
    /** Take the long step that ends at @p state. Throws what a load step may
     * throw. */
    ResetIteration::Solve
    take_step(State &state);

    ChainModel &model;
    const bool  wanted;
  };
} // namespace lumbricus

#endif
