// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/solvers/predictor.h>

#include <deal.II/base/patterns.h>

namespace lumbricus
{
  void
  Predictor::declare_parameters(dealii::ParameterHandler &prm)
  {
    prm.enter_subsection("Newton");
    prm.add_parameter("Predictor order",
                      order,
                      "[-] A load step starts from the polynomial of this "
                      "order in time through the last solutions; 0: from the "
                      "last one.",
                      dealii::Patterns::Integer(0, 3));
    prm.leave_subsection();
  }



  void
  Predictor::accept(const State &state)
  {
    if (order == 0)
      return;
    history.emplace_front(state.time, state.solution);
    if (history.size() > order + 1)
      history.pop_back();
  }



  void
  Predictor::restart(const State &state)
  {
    history.clear();
    accept(state);
  }



  void
  Predictor::shift(const Vector &change)
  {
    for (auto &[t, u] : history)
      u += change;
  }



  bool
  Predictor::ready() const
  {
    return history.size() > 1;
  }



  Vector
  Predictor::predict(const State &state) const
  {
    Vector solution = state.solution;
    if (!ready())
      return solution;
    solution = 0.;
    for (const auto &[t_i, u_i] : history)
      {
        double weight = 1.;
        for (const auto &[t_j, u_j] : history)
          if (t_j != t_i)
            weight *= (state.time - t_j) / (t_i - t_j);
        solution.add(weight, u_i);
      }
    return solution;
  }
} // namespace lumbricus
