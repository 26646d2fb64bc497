// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/input_limits.h>
#include <lumbricus/core/names.h>
#include <lumbricus/core/user_text.h>

namespace lumbricus
{
  std::string
  unfit_name(const std::string &name)
  {
    if (name.empty())
      return "is empty";
    if (name.size() > InputLimits::name)
      return "is longer than " + std::to_string(InputLimits::name) +
             " characters";
    if (!is_utf8(name))
      return "is not in UTF-8";
    if (has_control_character(name))
      return "has a tab, a line break or another control character";
    if (name.front() == ' ' || name.back() == ' ')
      return "has a blank at its end";
    if (name.find('/') != std::string::npos)
      return "has a '/', which separates sections";
    if (name.find('=') != std::string::npos)
      return "has a '=', which ends the name of a parameter";
    if (name.find('#') != std::string::npos)
      return "has a '#', which starts a comment";
    if (name.find(',') != std::string::npos)
      return "has a comma, which separates names";
    if (name.back() == '\\')
      return "has a '\\' at its end, with which a line goes on";
    // A word by which dealii::ParameterHandler knows another kind of entry.
    if (name == "alias")
      return "is a word that parameter files keep for themselves";
    return "";
  }
} // namespace lumbricus
