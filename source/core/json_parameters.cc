// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/json_parameters.h>

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <algorithm>
#include <istream>

namespace lumbricus
{
  namespace
  {
    using Tree = boost::property_tree::ptree;

    // The elements of an array have no names.
    bool
    is_array(const Tree &tree)
    {
      return !tree.empty() && tree.front().first.empty();
    }



    std::string
    list(const std::string &file_name,
         const std::string &name,
         const Tree        &array)
    {
      std::string text;
      for (const auto &[no_name, element] : array)
        {
          AssertThrow(element.empty(),
                      ExcInput(file_name + ": the list '" + name +
                               "' has a list or a section in it. Write lists "
                               "of lists as text, as in a .prm file."));
          text += (text.empty() ? "" : ", ") + element.data();
        }
      return text;
    }



    std::string
    content(const std::string &file_name, const Tree &tree)
    {
      std::string text;
      for (const auto &[name, child] : tree)
        if (is_array(child))
          text += "set " + name + " = " + list(file_name, name, child) + "\n";
        else if (child.empty())
          text += "set " + name + " = " + child.data() + "\n";
        else
          text +=
            "subsection " + name + "\n" + content(file_name, child) + "end\n";
      return text;
    }
  } // namespace



  std::string
  prm_from_json(const std::string &file_name, std::istream &in)
  {
    Tree        tree;
    std::string wrong;
    try
      {
        boost::property_tree::read_json(in, tree);
      }
    catch (const boost::property_tree::json_parser_error &error)
      {
        wrong = file_name + ", line " + std::to_string(error.line()) +
                ": this is no JSON, " + error.message() + ".";
      }
    AssertThrow(wrong.empty(), ExcInput(wrong));
    AssertThrow(!is_array(tree) && tree.data().empty(),
                ExcInput(file_name +
                         ": the file has to be one object of sections and "
                         "parameters, { \"Section\": { \"Name\": value } }."));
    return content(file_name, tree);
  }
} // namespace lumbricus
