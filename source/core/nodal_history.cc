// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/nodal_history.h>

#include <deal.II/base/exceptions.h>

namespace lumbricus
{
  namespace
  {
    // Made by the first history, whichever that is.
    std::set<std::string> &
    all_names()
    {
      static std::set<std::string> names;
      return names;
    }
  } // namespace



  NodalHistory::NodalHistory(const std::string &name)
    : own_name(name)
  {
    const bool is_new = all_names().insert(name).second;
    AssertThrow(is_new && name.find_first_of(" \t\n") == std::string::npos,
                dealii::ExcMessage("Another history is called '" + name +
                                   "', or the name has blanks."));
  }



  const std::string &
  NodalHistory::name() const
  {
    return own_name;
  }



  Vector &
  NodalHistory::in(State &state) const
  {
    return state.histories.at(own_name);
  }



  const Vector &
  NodalHistory::in(const State &state) const
  {
    return state.histories.at(own_name);
  }



  const std::set<std::string> &
  NodalHistory::names()
  {
    return all_names();
  }
} // namespace lumbricus
