// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/input_limits.h>
#include <lumbricus/core/json_nesting.h>
#include <lumbricus/core/user_text.h>
#include <lumbricus/parameters/json_parameters.h>
#include <lumbricus/parameters/prm_scanner.h>

#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/ptree.hpp>

#include <algorithm>
#include <istream>
#include <iterator>
#include <sstream>

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



    void
    check_depth(const std::string &file_name, const std::string &json)
    {
      const std::size_t i = where_nested_deeper(json, InputLimits::sections);
      AssertThrow(i == json.size(),
                  ExcInput(file_name + ", line " +
                           std::to_string(1 + std::count(json.begin(),
                                                         json.begin() + i,
                                                         '\n')) +
                           ": more than " +
                           std::to_string(InputLimits::sections) +
                           " objects and lists are in each other. Close "
                           "those that are complete."));
    }



    // One line of a .prm file holds it.
    void
    check_text(const std::string &file_name, const std::string &text)
    {
      const std::string unfit = unfit_for_a_line(text);
      AssertThrow(unfit.empty(),
                  ExcInput(file_name + ": '" + shortened(text) + "' has " +
                           unfit +
                           " in .prm files. Leave it out."));
    }



    void
    check_names(const std::string &file_name, const Tree &tree)
    {
      for (const auto &entry : tree)
        {
          const std::string &name = entry.first;
          check_text(file_name, name);
          AssertThrow(tree.count(name) == 1,
                      ExcInput(file_name + ": the name '" + shortened(name) +
                               "' is there twice in one section. Leave one "
                               "of them out."));
          AssertThrow(name.find_first_of("/=") == std::string::npos,
                      ExcInput(file_name + ": '" + shortened(name) +
                               "' is no name of a section or parameter. "
                               "Sections are objects, { \"Section\": { "
                               "\"Name\": value } }."));
        }
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
                      ExcInput(file_name + ": the list '" + shortened(name) +
                               "' has a list or a section in it. Write lists "
                               "of lists as text, as in a .prm file."));
          check_text(file_name, element.data());
          AssertThrow(element.data().find_first_of(",;") == std::string::npos,
                      ExcInput(file_name + ": the list '" + shortened(name) +
                               "' has '" + shortened(element.data()) +
                               "' in it, which is a list itself. Write all of "
                               "it as one text, as in a .prm file."));
          text += (text.empty() ? "" : ", ") + element.data();
        }
      return text;
    }



    std::string
    content(const std::string &file_name, const Tree &tree)
    {
      check_names(file_name, tree);
      std::string text;
      for (const auto &[name, child] : tree)
        {
          check_text(file_name, child.data());
          if (is_array(child))
            text += "set " + name + " = " + list(file_name, name, child) + "\n";
          else if (child.empty())
            text += "set " + name + " = " + child.data() + "\n";
          else
            text +=
              "subsection " + name + "\n" + content(file_name, child) + "end\n";
        }
      return text;
    }
  } // namespace



  std::string
  prm_from_json(const std::string &file_name, std::istream &in)
  {
    const std::string json(std::istreambuf_iterator<char>(in), {});
    check_depth(file_name, json);
    Tree        tree;
    std::string wrong;
    try
      {
        std::istringstream text(json);
        boost::property_tree::read_json(text, tree);
      }
    catch (const boost::property_tree::json_parser_error &error)
      {
        wrong =
          file_name + ", line " + std::to_string(error.line()) +
          ": this is no JSON, " + error.message() +
          ". Names and texts are in double quotes, commas between entries "
          "and not after the last, and there are no comments.";
      }
    AssertThrow(wrong.empty(), ExcInput(wrong));
    AssertThrow(!is_array(tree) && tree.data().empty(),
                ExcInput(file_name +
                         ": the file has to be one object of sections and "
                         "parameters, { \"Section\": { \"Name\": value } }."));
    return content(file_name, tree);
  }
} // namespace lumbricus
