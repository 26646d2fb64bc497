// SPDX-License-Identifier: LGPL-2.1-or-later
#include "path_equation.h"

namespace lumbricus
{
  namespace
  {
    // The equilibrium solves for the load parameter as long as this is there.
    class WithUnknownLoad
    {
    public:
      WithUnknownLoad(Equilibrium &equilibrium, LoadUnknown &load)
        : equilibrium(equilibrium)
      {
        equilibrium.set_load_unknown(&load);
      }

      ~WithUnknownLoad()
      {
        equilibrium.set_load_unknown(nullptr);
      }

      WithUnknownLoad(const WithUnknownLoad &) = delete;
      WithUnknownLoad &
      operator=(const WithUnknownLoad &) = delete;

    private:
      Equilibrium &equilibrium;
    };
  } // namespace



  PathEquation::PathEquation(ChainModel &model)
    : model(model)
  {}



  void
  PathEquation::set_loads(const LoadTime &t)
  {
    model.references.update_muscles(t);
    model.liquid_weight.set_time(t);
  }



  double
  PathEquation::difference() const
  {
    return 1e-6 * unit();
  }



  double
  PathEquation::unit() const
  {
    return model.parameters.load_stepping.first_step();
  }



  State
  PathEquation::solve(const State  &state,
                      const Vector &guess,
                      const double  t,
                      StepRecord   &step)
  {
    State next                      = state;
    next.time                       = t;
    next.globals[LoadUnknown::name] = {t};
    {
      const WithUnknownLoad with_load(model.equilibrium, *this);
      step.report = model.solve(next, t, guess);
    }
    next.time = next.globals.at(LoadUnknown::name)[0];
    next.globals.erase(LoadUnknown::name);
    next.past = {{state.time, state.solution}};
    return next;
  }



  Stability::Ends
  PathEquation::stability(const State &state)
  {
    model.set_to(state);
    Globals globals            = state.globals;
    globals[LoadUnknown::name] = {state.time};
    const WithUnknownLoad with_load(model.equilibrium, *this);
    // With a factorisation of its own: a motion that hangs on what was kept would not
    // be the same after a restart.
    model.equilibrium.forget_factors();
    model.equilibrium.linearise({state.solution, globals});
    return model.stability().ends();
  }
} // namespace lumbricus
