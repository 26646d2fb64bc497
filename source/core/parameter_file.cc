// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/json_parameters.h>
#include <lumbricus/core/parameter_file.h>
#include <lumbricus/core/pattern_words.h>
#include <lumbricus/core/patterns.h>
#include <lumbricus/core/prm_scanner.h>
#include <lumbricus/core/text_lines.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
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
      const std::string trimmed =
        dealii::Utilities::trim(line.substr(0, line.find('#')));
      for (const std::string keyword : {"include", "INCLUDE"})
        if (trimmed.size() > keyword.size() &&
            trimmed.compare(0, keyword.size(), keyword) == 0 &&
            std::isspace(trimmed[keyword.size()]))
          return dealii::Utilities::trim(trimmed.substr(keyword.size()));
      return "";
    }



    bool
    is_text(const std::string &content)
    {
      return std::none_of(content.begin(), content.end(), [](const char c) {
        return std::iscntrl(static_cast<unsigned char>(c)) && !std::isspace(c);
      });
    }



    // "A/B/" of "A/B/Name".
    std::string
    parent_of(const std::string &path)
    {
      const auto slash = path.rfind('/');
      return slash == std::string::npos ? "" : path.substr(0, slash + 1);
    }



    std::string
    last_name(const std::string &path)
    {
      return path.substr(parent_of(path).size());
    }



    // The names of those @p known that are in the same section as @p path.
    std::vector<std::string>
    names_beside(const std::string &path, const std::set<std::string> &known)
    {
      std::vector<std::string> names;
      for (const std::string &other : known)
        if (parent_of(other) == parent_of(path))
          names.push_back(last_name(other));
      return names;
    }



    // The only one of the same name in another section; empty if there is none,
    // or more.
    std::string
    same_name_elsewhere(const std::string           &path,
                        const std::set<std::string> &known)
    {
      std::string found;
      for (const std::string &other : known)
        if (last_name(other) == last_name(path))
          {
            if (!found.empty())
              return "";
            found = other;
          }
      return found;
    }



    // Whether a value is positive, but tiny or infinite.
    bool
    is_extreme(const std::string &value)
    {
      char        *end    = nullptr;
      const double number = std::strtod(value.c_str(), &end);
      return end == value.c_str() + value.size() && number > 0. &&
             !PositiveNumber().match(value);
    }



    std::string
    quoted_list(const std::vector<std::string> &names)
    {
      std::string list;
      for (const std::string &name : names)
        list += (list.empty() ? "'" : ", '") + name + "'";
      return list.empty() ? "none" : list;
    }
  } // namespace



  void
  ParameterFile::read(const std::string &file_name)
  {
    std::ifstream file_stream(file_name);
    AssertThrow(file_stream && !std::filesystem::is_directory(file_name),
                ExcInput(
                  "The parameter file '" + file_name + "'" +
                  (being_read.empty() ?
                     std::string() :
                     ", which '" + being_read.back() + "' includes,") +
                  " cannot be read. Give the path of a .prm or .json file" +
                  (being_read.empty() ?
                     "; the gallery in parameters/ has some." :
                     ", from the folder of the file that includes it.")));
    const std::string content = text_of(file_stream);
    AssertThrow(is_text(content),
                ExcInput("The parameter file '" + file_name +
                         "' is not plain text. Give a .prm or .json file, in "
                         "UTF-8."));
    std::istringstream in(content);
    if (std::filesystem::path(file_name).extension() == ".json")
      {
        sources.push_back({file_name, prm_from_json(file_name, in), false});
        return;
      }
    const std::string file = std::filesystem::canonical(file_name).string();
    AssertThrow(std::count(being_read.begin(), being_read.end(), file) == 0,
                ExcInput("The parameter file '" + file_name +
                         "' includes itself, perhaps through another file. "
                         "Remove one of the 'include' lines."));
    being_read.push_back(file);

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
                                 "'set' or 'subsection' of a file. Move it "
                                 "up."));
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
    sources.push_back({file_name, text, true});
  }



  void
  ParameterFile::set(const std::string &setting)
  {
    const auto               equals = setting.find('=');
    const std::string        full   = setting.substr(0, equals);
    std::vector<std::string> path =
      dealii::Utilities::split_string_list(full + "/", '/');
    AssertThrow(equals != std::string::npos && !path.empty() &&
                  std::count(path.begin(), path.end(), "") == 0,
                ExcInput("--set '" + setting +
                         "' is not of the form --set \"Section/Name=value\"."));
    const std::string unfit = unfit_for_a_line(setting);
    AssertThrow(unfit.empty(),
                ExcInput("--set '" + setting + "' has " + unfit +
                         " in parameter files. Leave it out."));
    const std::string name = path.back();
    path.pop_back();

    std::string text;
    for (const std::string &section : path)
      text += "subsection " + section + "\n";
    text += "set " + name + " =" + setting.substr(equals + 1) + "\n";
    for (unsigned int i = 0; i < path.size(); ++i)
      text += "end\n";
    sources.push_back({"--set '" + setting + "'", text, false});
  }



  std::string
  ParameterFile::Source::place(const unsigned int line) const
  {
    return has_lines ? name + ", line " + std::to_string(line) : name;
  }



  std::string
  ParameterFile::Source::wrong_value(const std::string &message) const
  {
    static const std::regex format(
      "Line <([0-9]+)>[\\s\\S]*The entry value\\s+([\\s\\S]*?)\\s+for the entry named"
      "[\\s\\S]*does not match the given pattern:\\s+([\\s\\S]*)");
    std::smatch parts;
    if (!std::regex_match(message, parts, format))
      return name + ": " + message;

    // A value that goes on over several lines is reported with the last one.
    const unsigned int number = std::stoul(parts[1]);
    std::string        path;
    for (const PrmLine &line : scan_prm(text))
      if (!line.is_section && line.number <= number)
        path = line.path;
    return place(number) + ": the parameter '" + path + "' is '" +
           parts[2].str() + "', but has to be " + pattern_in_words(parts[3]) +
           (is_extreme(parts[2]) && parts[3] == "[A number > 0]" ?
              ", from 1e-100 to 1e100." :
              ".");
  }



  void
  ParameterFile::check_syntax() const
  {
    bool any = false;
    for (const Source &source : sources)
      {
        const PrmMistake mistake = first_mistake(source.text);
        AssertThrow(mistake.line == 0,
                    ExcInput(source.place(mistake.line) + ": " + mistake.what +
                             "\nThe lines of a parameter file are 'set Name = "
                             "value', 'subsection Name' and, for each of "
                             "these, 'end'; # starts a comment."));
        for (const PrmLine &line : scan_prm(source.text))
          any = any || !line.is_section;
      }
    AssertThrow(any || sources.empty(),
                ExcInput("The parameter file '" + sources.back().name +
                         "' sets nothing. Copy one of the gallery in "
                         "parameters/ and change it."));
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
        reason = source.wrong_value(plain_message(exception));
      }
    catch (const dealii::ExceptionBase &exception)
      {
        // What first_mistake() does not know.
        reason = source.name + ": " + plain_message(exception);
      }
    AssertThrow(reason.empty(), ExcInput(reason));
  }



  ParameterFile::Names
  ParameterFile::known_names() const
  {
    std::ostringstream declared_text;
    prm.print_parameters(declared_text, short_style);
    Names known;
    for (const PrmLine &line : scan_prm(declared_text.str()))
      (line.is_section ? known.sections : known.entries).insert(line.path);
    return known;
  }



  void
  ParameterFile::check_names() const
  {
    const Names known = known_names();
    for (const Source &source : sources)
      for (const PrmLine &line : scan_prm(source.text))
        {
          const auto &alike = line.is_section ? known.sections : known.entries;
          AssertThrow(alike.count(line.path) > 0,
                      ExcInput(unknown_name(source, line, known)));
        }
  }



  void
  ParameterFile::check_names_in_known_sections() const
  {
    const Names known = known_names();
    for (const Source &source : sources)
      for (const PrmLine &line : scan_prm(source.text))
        {
          std::string section = parent_of(line.path);
          if (!section.empty())
            section.pop_back();
          AssertThrow(line.is_section || known.entries.count(line.path) > 0 ||
                        (!section.empty() &&
                         known.sections.count(section) == 0),
                      ExcInput(unknown_name(source, line, known)));
        }
  }



  std::string
  ParameterFile::unknown_name(const Source  &source,
                              const PrmLine &line,
                              const Names   &known) const
  {
    const std::string what = line.is_section ? "section" : "parameter";
    const std::string opening =
      source.place(line.number) + ": the " + what + " '" + line.path + "' is ";
    const std::string name = last_name(line.path);

    const std::string choice =
      line.is_section ? other_choice(line.path, known.entries) : "";
    if (!choice.empty())
      return opening + "not used, because " + choice + ". Choose '" + name +
             "' there, or remove the section.";

    // Suggest among the neighbours in the same section.
    const auto &alike = line.is_section ? known.sections : known.entries;
    const auto &other = line.is_section ? known.entries : known.sections;
    const std::vector<std::string> neighbours = names_beside(line.path, alike);
    const std::string              hint       = nearest(name, neighbours);
    const std::string elsewhere = same_name_elsewhere(line.path, alike);
    std::string       message   = opening + "unknown";
    if (other.count(line.path) > 0)
      message += line.is_section ? ": that is a parameter. Set it to a value." :
                                   ": that is a section. Set a parameter in "
                                   "it.";
    else if (!hint.empty())
      message += ".\nDid you mean '" + parent_of(line.path) + hint + "'?";
    else if (!elsewhere.empty())
      message += ".\nDid you mean '" + elsewhere + "'?";
    else if (line.is_section)
      message +=
        " or not used.\nThe sections used there: " + quoted_list(neighbours) +
        ". A section is used when another parameter chooses it or "
        "lists its name.";
    else
      message +=
        ".\nThe parameters known there: " + quoted_list(neighbours) + ".";
    return message + "\n'lumbricus --parameters' lists all parameters.";
  }



  std::string
  ParameterFile::other_choice(const std::string           &section,
                              const std::set<std::string> &known_entries) const
  {
    const std::string        parent = parent_of(section);
    std::vector<std::string> path   = split_path(section);
    const std::string        name   = path.back();
    path.pop_back();

    const auto takes = [&](const std::string &entry, const std::string &value) {
      try
        {
          prm.set(entry, value);
          return true;
        }
      catch (const dealii::ExceptionBase &)
        {
          return false;
        }
    };

    for (const std::string &outer : path)
      prm.enter_subsection(outer);
    std::string choice;
    for (const std::string &entry : names_beside(section, known_entries))
      {
        const std::string value = prm.get(entry);
        // A text takes anything, a choice only the names there are.
        if (choice.empty() && !takes(entry, "?") && takes(entry, name))
          choice = "'" + parent + entry + "' is '" + value + "'";
      }
    for (std::size_t i = 0; i < path.size(); ++i)
      prm.leave_subsection();
    return choice;
  }



  bool
  ParameterFile::extend(ParameterOwner &root)
  {
    try
      {
        return root.extend_parameters(prm, Extent::chosen);
      }
    catch (const ExcInput &)
      {
        // What is missing may have been set under a misspelt name.
        check_names_in_known_sections();
        throw;
      }
  }



  void
  ParameterFile::parse(ParameterOwner &root)
  {
    check_syntax();
    root.declare_parameters(prm);
    do
      for (const Source &source : sources)
        parse_source(source, true);
    while (extend(root));

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
