// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/parameter_file.h>
#include <lumbricus/core/prm_scanner.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace lumbricus
{
  namespace
  {
    using Style = dealii::ParameterHandler::OutputStyle;

    const Style short_style = dealii::ParameterHandler::ShortPRM |
                              dealii::ParameterHandler::KeepDeclarationOrder;

    // "include file.prm" at the start of a line: the file, or nothing.
    std::string
    included_file(const std::string &line)
    {
      const std::string trimmed = dealii::Utilities::trim(line);
      for (const std::string keyword : {"include ", "INCLUDE "})
        if (trimmed.compare(0, keyword.size(), keyword) == 0)
          return dealii::Utilities::trim(trimmed.substr(keyword.size()));
      return "";
    }
  } // namespace



  void
  ParameterFile::read(const std::string &file_name)
  {
    std::ifstream in(file_name);
    AssertThrow(in && !std::filesystem::is_directory(file_name),
                ExcInput("The parameter file '" + file_name +
                         "' cannot be read. Give the path of a .prm file; "
                         "the gallery in parameters/ has some."));
    AssertThrow(
      std::count(being_read.begin(), being_read.end(), file_name) == 0,
      ExcInput("The parameter file '" + file_name + "' includes itself."));
    being_read.push_back(file_name);

    // Lines with an include are left blank, so that line numbers stay right.
    std::string text;
    std::string line;
    bool        at_top = true;
    for (unsigned int number = 1; std::getline(in, line); ++number)
      {
        const std::string included = included_file(line);
        const std::string content =
          dealii::Utilities::trim(line.substr(0, line.find('#')));
        if (!included.empty())
          {
            AssertThrow(at_top,
                        ExcInput(file_name + ", line " +
                                 std::to_string(number) +
                                 ": 'include' must come before the first "
                                 "'set' or 'subsection' of a file."));
            const std::filesystem::path path(included);
            read(path.is_absolute() ?
                   included :
                   (std::filesystem::path(file_name).parent_path() / path)
                     .string());
          }
        else
          {
            at_top = at_top && content.empty();
            text += line;
          }
        text += '\n';
      }
    being_read.pop_back();
    sources.push_back({file_name, text});
  }



  void
  ParameterFile::set(const std::string &setting)
  {
    const auto equals = setting.find('=');
    AssertThrow(equals != std::string::npos && equals > 0,
                ExcInput("--set '" + setting +
                         "': expected \"Section/Name=value\"."));
    std::vector<std::string> path = split_path(setting.substr(0, equals));
    const std::string        name = path.back();
    path.pop_back();

    std::string text;
    for (const std::string &section : path)
      text += "subsection " + section + "\n";
    text += "set " + name + " =" + setting.substr(equals + 1) + "\n";
    for (unsigned int i = 0; i < path.size(); ++i)
      text += "end\n";
    sources.push_back({"--set '" + setting + "'", text});
  }



  void
  ParameterFile::parse_source(const Source &source, const bool skip_undefined)
  {
    std::string reason;
    try
      {
        std::istringstream in(source.text);
        prm.parse_input(in, source.name, "", skip_undefined);
      }
    catch (const dealii::ParameterHandler::ExcInvalidEntryForPattern &exception)
      {
        // The exception knows the line; the outline knows the section.
        reason = plain_message(exception);
        for (const PrmLine &line : scan_prm(source.text))
          if (reason.find("Line <" + std::to_string(line.number) + ">") == 0)
            reason =
              "Parameter '" + line.path + "' has a wrong value.\n" + reason;
      }
    catch (const dealii::ExceptionBase &exception)
      {
        reason = source.name + ": " + plain_message(exception);
      }
    AssertThrow(reason.empty(), ExcInput(reason));
  }



  void
  ParameterFile::check_names() const
  {
    std::ostringstream declared_text;
    prm.print_parameters(declared_text, short_style);
    std::set<std::string> entries, sections;
    for (const PrmLine &line : scan_prm(declared_text.str()))
      (line.is_section ? sections : entries).insert(line.path);

    for (const Source &source : sources)
      for (const PrmLine &line : scan_prm(source.text))
        {
          const auto &known = line.is_section ? sections : entries;
          if (known.count(line.path) > 0)
            continue;

          // Suggest among the neighbours in the same section.
          const auto        slash = line.path.rfind('/');
          const std::string parent =
            slash == std::string::npos ? "" : line.path.substr(0, slash + 1);
          std::vector<std::string> neighbours;
          for (const std::string &path : known)
            if (path.compare(0, parent.size(), parent) == 0 &&
                path.find('/', parent.size()) == std::string::npos)
              neighbours.push_back(path.substr(parent.size()));

          const std::string what = line.is_section ? "section" : "parameter";
          const std::string hint =
            nearest(line.path.substr(parent.size()), neighbours);
          std::string message = source.name + ", line " +
                                std::to_string(line.number) + ": the " + what +
                                " '" + line.path +
                                "' is unknown, or not used by what was chosen.";
          if (!hint.empty())
            message += "\nDid you mean '" + parent + hint + "'?";
          else
            {
              message += "\nThe " + what + "s known there:";
              for (const std::string &neighbour : neighbours)
                message += (neighbour == neighbours.front() ? " '" : ", '") +
                           neighbour + "'";
              message += neighbours.empty() ? " none." : ".";
            }
          AssertThrow(false,
                      ExcInput(message + "\n'lumbricus --parameters' lists "
                                         "all parameters there are."));
        }
  }



  void
  ParameterFile::parse(ParameterOwner &root)
  {
    root.declare_parameters(prm);
    do
      for (const Source &source : sources)
        parse_source(source, true);
    while (root.extend_parameters(prm, Extent::chosen));

    check_names();
    for (const Source &source : sources)
      parse_source(source, false);
    root.check_parameters();
  }



  void
  ParameterFile::print_resolved(std::ostream &out)
  {
    prm.print_parameters(out, short_style);
  }



  void
  ParameterFile::print_reference(ParameterOwner &root, std::ostream &out)
  {
    dealii::ParameterHandler all;
    root.declare_parameters(all);
    while (root.extend_parameters(all, Extent::everything))
      ;
    all.print_parameters(out,
                         dealii::ParameterHandler::PRM |
                           dealii::ParameterHandler::KeepDeclarationOrder);
  }
} // namespace lumbricus
