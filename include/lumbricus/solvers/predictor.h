// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_solvers_predictor_h
#define lumbricus_solvers_predictor_h

#include <lumbricus/core/parameter_owner.h>
#include <lumbricus/core/state.h>

#include <deque>
#include <utility>

namespace lumbricus
{
  /**
   * Where Newton's method starts in a load step: the polynomial through the
   * last solutions, of the given order in time,
   *
   *   u(t) = sum_i u_i prod_(j != i) (t - t_j) / (t_i - t_j).
   */
  class Predictor : public ParameterOwner
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override;

    /** A load step has ended in @p state. */
    void
    accept(const State &state);

    /** Forget all before @p state: the mesh is new, or the run starts from
     * here. */
    void
    restart(const State &state);

    /** The solution of the last state, and with it all before, is another: by
     * @p change. */
    void
    shift(const Vector &change);

    /** Whether there is anything to extrapolate from. */
    bool
    ready() const;

    /** The solution that is expected at the time of @p state; without a
     * history that of @p state. */
    Vector
    predict(const State &state) const;

  private:
    unsigned int                          order = 1;
    std::deque<std::pair<double, Vector>> history;
  };
} // namespace lumbricus

#endif
