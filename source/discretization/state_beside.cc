// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/nodal_history.h>
#include <lumbricus/discretization/state_beside.h>

#include <deal.II/base/exceptions.h>

#include <string>

#include "nodal_displacement.h"

namespace lumbricus
{
  namespace
  {
    // What the state beside has besides histories and globals.
    const std::string displacement = "displacement";
    const std::string time         = "time";



    // The name of what a state beside calls @p name without that.
    std::string
    name_beside(const std::string &name)
    {
      return NodalHistory::of_state_beside(name);
    }



    // The entries of a state beside, by the names that it has for them.
    template <typename Entries>
    Entries
    entries_beside(const Entries &entries)
    {
      const auto n = name_beside("").size();
      Entries    found;
      for (const auto &[name, entry] : entries)
        if (NodalHistory::is_of_state_beside(name))
          found.emplace(name.substr(n), entry);
      return found;
    }



    // The other ones.
    template <typename Entries>
    Entries
    other_entries(const Entries &entries)
    {
      Entries found;
      for (const auto &entry : entries)
        if (!NodalHistory::is_of_state_beside(entry.first))
          found.insert(entry);
      return found;
    }
  } // namespace



  bool
  has_state_beside(const State &state)
  {
    return state.globals.count(name_beside(time)) > 0;
  }



  double
  time_beside(const State &state)
  {
    return state.globals.at(name_beside(time))[0];
  }



  void
  put_beside(const MixedSpace &space, const State &beside, State &state)
  {
    Assert(!has_state_beside(beside), dealii::ExcInternalError());
    for (const auto &[name, history] : beside.histories)
      state.histories[name_beside(name)] = history;
    for (const auto &[name, values] : beside.globals)
      state.globals[name_beside(name)] = values;
    state.globals[name_beside(time)] = {beside.time};
    Vector &u = state.histories[name_beside(displacement)];
    u.reinit(beside.histories.begin()->second, true);
    write_history(space, beside.solution, u);
  }



  State
  state_beside(const MixedSpace &space, const State &state)
  {
    Assert(has_state_beside(state), dealii::ExcInternalError());
    State beside      = space.zero_state({});
    beside.histories  = entries_beside(state.histories);
    beside.globals    = entries_beside(state.globals);
    beside.time       = time_beside(state);
    beside.last_time  = beside.time;
    write_displacement(space,
                       beside.histories.at(displacement),
                       beside.solution);
    beside.histories.erase(displacement);
    beside.globals.erase(time);
    return beside;
  }



  State
  without_state_beside(const State &state)
  {
    State alone     = state;
    alone.histories = other_entries(state.histories);
    alone.globals   = other_entries(state.globals);
    alone.past.clear();
    return alone;
  }
} // namespace lumbricus
