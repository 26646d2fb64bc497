// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_continuation_predictor_h
#define lumbricus_continuation_predictor_h

#include <lumbricus/core/state.h>
#include <lumbricus/parameters/parameter_owner.h>

namespace lumbricus
{
  /**
   * Where Newton's method starts in a load step: the polynomial through the
   * last solutions u_i (State::past and that of the state itself), of the given
   * order in time,
   *
   *   u(t) = sum_i u_i prod_(j != i) (t - t_j) / (t_i - t_j).
   */
  class Predictor : public ParameterOwner
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    /** A load step led from @p before to @p after, whose State::past this
     * writes. */
    void
    accept(const State &before, State &after) const;

    /** The solution that is expected at time @p t, later than that of
     * @p state; without a past its solution. */
    Vector
    predict(const State &state, const double t) const;

  private:
    unsigned int order = 1;
  };
} // namespace lumbricus

#endif
