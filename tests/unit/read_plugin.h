// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_tests_unit_read_plugin_h
#define lumbricus_tests_unit_read_plugin_h

#include <lumbricus/parameters/registry.h>

#include <deal.II/base/parameter_handler.h>

#include <memory>
#include <string>

namespace lumbricus
{
  /** A plugin with its parameters read from @p text, in rounds as files are. */
  template <class Base>
  std::unique_ptr<Base>
  read_plugin(const std::string &name, const std::string &text = "")
  {
    dealii::ParameterHandler prm;
    auto                     plugin = Registry<Base>::create(name);
    plugin->declare_parameters(prm);
    do
      prm.parse_input_from_string(text, "", true);
    while (plugin->extend_parameters(prm, Extent::chosen));
    // Now that everything is declared, what is not known is an error.
    prm.parse_input_from_string(text);
    plugin->check_parameters();
    return plugin;
  }



  /** The message of the ExcInput that @p action throws; empty if it does not.
   */
  template <typename Action>
  std::string
  input_error(const Action &action)
  {
    try
      {
        action();
      }
    catch (const ExcInput &exception)
      {
        return plain_message(exception);
      }
    return "";
  }



  inline bool
  contains(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }
} // namespace lumbricus

#endif
