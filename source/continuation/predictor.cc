// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/continuation/predictor.h>

#include <deal.II/base/patterns.h>

#include <vector>

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
  Predictor::accept(const State &before, State &after) const
  {
    after.past = before.past;
    after.past.push_front({before.time, before.solution});
    if (after.past.size() > order)
      after.past.resize(order);
  }



  Vector
  Predictor::predict(const State &state, const double t) const
  {
    if (order == 0 || state.past.empty())
      return state.solution;
    std::vector<const State::Past *> known;
    for (const State::Past &earlier : state.past)
      if (known.size() < order)
        known.push_back(&earlier);

    // The polynomial in Lagrange's form, the state itself last.
    Vector       solution = state.solution;
    const double t_0      = state.time;
    double       weight   = 1.;
    for (const State::Past *earlier : known)
      weight *= (t - earlier->time) / (t_0 - earlier->time);
    solution *= weight;
    for (const State::Past *earlier : known)
      {
        const double t_i = earlier->time;
        weight           = (t - t_0) / (t_i - t_0);
        for (const State::Past *other : known)
          if (other != earlier)
            weight *= (t - other->time) / (t_i - other->time);
        solution.add(weight, earlier->solution);
      }
    return solution;
  }
} // namespace lumbricus
