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



    const std::string boundary = "boundary:";
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



  std::string
  NodalHistory::of_boundary(const std::string &condition)
  {
    std::string word;
    for (const char c : condition)
      if (c == '%')
        word += "%25";
      else if (c == ' ')
        word += "%20";
      else
        word += c;
    return boundary + word;
  }



  bool
  NodalHistory::is_known(const std::string &name)
  {
    return all_names().count(name) > 0 ||
           (name.size() > boundary.size() &&
            name.compare(0, boundary.size(), boundary) == 0);
  }
} // namespace lumbricus
