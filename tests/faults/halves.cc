// SPDX-License-Identifier: LGPL-2.1-or-later
// A continuation: each step in two halves, and each longer than the last.
#include <lumbricus/continuation/continuation.h>
#include <lumbricus/parameters/registry.h>
#include <lumbricus/program/chain_model.h>
#include <lumbricus/program/run_watch.h>

#include <algorithm>

namespace
{
  using namespace lumbricus;

  /** Steps of the size h, 1.25 h, 1.25^2 h, ..., in two halves each. */
  class Halves : public Continuation
  {
  public:
    void
    declare_parameters(dealii::ParameterHandler &prm) override
    {
      prm.add_parameter("Growth", growth, "[-] From step to step.");
    }

    void
    initialize(const RunParameters &parameters) override
    {
      size = parameters.load_stepping.first_step();
    }

    StepRecord
    advance(ChainModel        &model,
            State             &state,
            const unsigned int number,
            RunWatch          &watch,
            Log               &log) override
    {
      const double from = state.time;
      const double to   = std::min(from + size,
                                 model.parameters.load_stepping.end_time());
      StepRecord   step;
      for (const double time : {0.5 * (from + to), to})
        {
          state.time = time;
          watch.begin_step(number, time);
          step.report = model.solve(state);
        }
      step.number = number;
      step.time   = to;
      step.size   = to - from;
      size *= growth;
      log << "        two halves\n";
      return step;
    }

    Numbers
    numbers() const override
    {
      return {{"size", size}};
    }

    bool
    set_numbers(const Numbers &numbers) override
    {
      if (numbers.size() != 1 || numbers.count("size") == 0 ||
          numbers.at("size") <= 0.)
        return false;
      size = numbers.at("size");
      return true;
    }

  private:
    double growth = 1.25;
    double size   = 0.;
  };

  const Register<Continuation, Halves>
    halves("in halves", "each step in two halves.");
} // namespace
