// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/nodal_history.h>

#include <deal.II/base/exceptions.h>

namespace lumbricus
{
  namespace
  {
    // Made by the first history, whichever that is: the names of those that all
    // runs have, and of those that some have.
    std::set<std::string> &
    names_of(const NodalHistory::Runs runs)
    {
      static std::set<std::string> of_all, of_some;
      return runs == NodalHistory::Runs::all ? of_all : of_some;
    }



    bool
    is_name(const std::string &name)
    {
      return names_of(NodalHistory::Runs::all).count(name) > 0 ||
             names_of(NodalHistory::Runs::some).count(name) > 0;
    }



    const std::string boundary = "boundary:", branch = "branch:",
                      beside = "beside:";



    bool
    begins_with(const std::string &name, const std::string &prefix)
    {
      return name.size() > prefix.size() &&
             name.compare(0, prefix.size(), prefix) == 0;
    }
  } // namespace



  NodalHistory::NodalHistory(const std::string &name, const Runs runs)
    : own_name(name)
  {
    const bool is_new = !is_name(name);
    names_of(runs).insert(name);
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
    return names_of(Runs::all);
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



  std::string
  NodalHistory::of_branch(const unsigned int k, const unsigned int part)
  {
    return branch + std::to_string(k) + ":" + std::to_string(part);
  }



  std::string
  NodalHistory::of_state_beside(const std::string &name)
  {
    return beside + name;
  }



  bool
  NodalHistory::is_of_state_beside(const std::string &name)
  {
    return begins_with(name, beside);
  }



  bool
  NodalHistory::is_known(const std::string &name)
  {
    return is_name(name) || begins_with(name, boundary) ||
           begins_with(name, branch) || begins_with(name, beside);
  }
} // namespace lumbricus
