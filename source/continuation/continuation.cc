// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/continuation/continuation.h>
#include <lumbricus/activation/held_values.h>
#include <lumbricus/core/exceptions.h>
#include <lumbricus/program/chain_model.h>

#include <algorithm>

namespace lumbricus
{
  void
  Continuation::open(const ChainModel &model)
  {
    const Anatomy &anatomy = model.parameters.anatomy;
    for (unsigned int m = 0; m < anatomy.n_muscles(); ++m)
      {
        const auto held =
          anatomy.muscle(m).action().activation()->held_values();
        AssertThrow(held == nullptr,
                    ExcInput(about_parameter(
                      "Path/Control",
                      "is '" + model.parameters.continuation.chosen_name() +
                        "', which asks no controller, but the muscle '" +
                        anatomy.muscle(m).name() +
                        "' has one. Set it to 'time'.")));
      }
  }



  bool
  Continuation::finished(const ChainModel &model, const State &state) const
  {
    return model.parameters.load_stepping.finished(state.time);
  }



  void
  Continuation::adapted(State &state) const
  {
    state.past.clear();
  }



  bool
  Continuation::has_same_names(const Numbers &a, const Numbers &b)
  {
    return std::equal(a.begin(),
                      a.end(),
                      b.begin(),
                      b.end(),
                      [](const auto &one, const auto &other) {
                        return one.first == other.first;
                      });
  }
} // namespace lumbricus
