// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/names.h>
#include <lumbricus/core/user_text.h>
#include <lumbricus/parameters/parameter_file.h>
#include <lumbricus/parameters/pattern_words.h>
#include <lumbricus/parameters/patterns.h>
#include <lumbricus/parameters/prm_scanner.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>
#include <utility>

namespace lumbricus
{
  namespace
  {
    using Style = dealii::ParameterHandler::OutputStyle;

    const Style short_style = dealii::ParameterHandler::ShortPRM |
                              dealii::ParameterHandler::KeepDeclarationOrder;

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
             value.find_first_of("xX") == std::string::npos &&
             !PositiveNumber().match(value);
    }



    // What is wrong with a name out of a list, or with the only one.
    std::string
    unfit_name_in(const std::string &value)
    {
      for (const std::string &name :
           dealii::Utilities::split_string_list(value, ','))
        {
          const std::string unfit = unfit_name(name);
          if (!unfit.empty())
            return ": '" + shortened(name) + "' " + unfit;
        }
      return "";
    }



    // The message on a value that a pattern of this description refuses.
    std::string
    wrong_value(const std::string &place,
                const PrmLine     &line,
                const std::string &description)
    {
      const auto has = [&](const std::string &text) {
        return description.find(text) != std::string::npos;
      };
      std::string words = pattern_in_words(description);
      if (description == "[A number > 0]" && is_extreme(line.value))
        words += ", from 1e-100 to 1e100";
      else if (has("[Name]"))
        words += unfit_name_in(line.value);
      if (line.value.find('{') != std::string::npos && !has("[Name]"))
        words += ". Braces have no meaning here";
      return place + ": the parameter '" + line.path + "' is '" +
             shortened(line.value) + "', but has to be " + words + ".";
    }
  } // namespace



  void
  ParameterFile::read(const std::string &file_name)
  {
    for (ParameterSource &source : read_parameter_file(file_name))
      sources.push_back(std::move(source));
  }



  void
  ParameterFile::set(const std::string &setting)
  {
    sources.push_back(read_setting(setting));
  }



  void
  ParameterFile::take_resolved(const std::string &file_name,
                               const std::string &text)
  {
    sources.push_back(resolved_source(file_name, text));
  }



  std::string
  ParameterFile::path_of_setting(const std::string &setting)
  {
    std::string path;
    for (const std::string &name :
         split_path(setting.substr(0, setting.find('='))))
      path += (path.empty() ? "" : "/") + name;
    return path;
  }



  void
  ParameterFile::check_any() const
  {
    bool any = sources.empty();
    for (const ParameterSource &source : sources)
      any = any || std::any_of(source.lines.begin(),
                               source.lines.end(),
                               [](const PrmLine &line) {
                                 return !line.is_section;
                               });
    AssertThrow(any,
                ExcInput("The parameter file '" + sources.back().name +
                         "' sets nothing. Copy one of the gallery in "
                         "parameters/ and change it."));
  }



  void
  ParameterFile::set_known_values()
  {
    const Names known = known_names();
    for (const ParameterSource &source : sources)
      for (const PrmLine &line : source.lines)
        if (!line.is_section && known.have(line))
          set_value(source, line);
  }



  // Not by ParameterHandler::parse_input(), which leaves values in braces to
  // its MultipleParameterLoop: it neither checks them nor hands them on.
  void
  ParameterFile::set_value(const ParameterSource &source, const PrmLine &line)
  {
    std::vector<std::string> path = split_path(line.path);
    const std::string        name = path.back();
    path.pop_back();

    for (const std::string &section : path)
      prm.enter_subsection(section);
    std::string reason;
    try
      {
        prm.set(name, line.value);
      }
    catch (const dealii::ParameterHandler::ExcValueDoesNotMatchPattern
             &exception)
      {
        // "... does not match the given pattern <description>."
        const std::string message = plain_message(exception);
        const std::string before  = "the given pattern <";
        const auto        begin   = message.rfind(before) + before.size();
        reason                    = wrong_value(source.place(line),
                             line,
                             message.substr(begin, message.rfind('>') - begin));
      }
    catch (const ExcParameter &exception)
      {
        reason = source.place(line) + ": " +
                 about_parameter(line.path, exception.complaint());
      }
    catch (const dealii::ExceptionBase &exception)
      {
        reason = source.place(line) + ": the parameter '" + line.path +
                 "' is '" + shortened(line.value) + "': " +
                 plain_message(exception);
      }
    for (std::size_t i = 0; i < path.size(); ++i)
      prm.leave_subsection();
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



  ParameterFile::Names
  ParameterFile::names_of_files(const MakeRoot &make_root) const
  {
    ParameterFile files;
    for (const ParameterSource &source : sources)
      if (!source.is_setting)
        files.sources.push_back(source);
    const std::unique_ptr<ParameterOwner> root = make_root();
    root->declare_parameters(files.prm);
    for (bool more = true; more;)
      {
        files.set_known_values();
        try
          {
            more = files.extend(*root);
          }
        catch (const ExcInput &)
          {
            // The files alone lack something that the settings have.
            more = false;
          }
      }
    return files.known_names();
  }



  void
  ParameterFile::check_names(const MakeRoot &make_root)
  {
    const Names            known = known_names();
    std::unique_ptr<Names> of_files;
    for (const ParameterSource &source : sources)
      {
        std::string unused_section; // with a '/' at its end
        for (const PrmLine &line : source.lines)
          {
            if (known.have(line) ||
                (!unused_section.empty() &&
                 line.path.compare(0,
                                   unused_section.size(),
                                   unused_section) == 0 &&
                 of_files->have(line)))
              continue;
            if (!source.is_setting && sources.back().is_setting)
              {
                if (of_files == nullptr)
                  of_files = std::make_unique<Names>(names_of_files(make_root));
                if (of_files->have(line))
                  {
                    unused_names.push_back("'" + line.path + "' in " +
                                           source.place(line));
                    if (line.is_section)
                      unused_section = line.path + "/";
                    continue;
                  }
              }
            AssertThrow(false, ExcInput(unknown_name(source, line, known)));
          }
      }
  }



  void
  ParameterFile::check_names_in_known_sections() const
  {
    const Names known = known_names();
    for (const ParameterSource &source : sources)
      for (const PrmLine &line : source.lines)
        {
          std::string section = parent_of(line.path);
          if (!section.empty())
            section.pop_back();
          AssertThrow(line.is_section || known.have(line) ||
                        (!section.empty() &&
                         known.sections.count(section) == 0),
                      ExcInput(unknown_name(source, line, known)));
        }
  }



  std::string
  ParameterFile::unknown_name(const ParameterSource &source,
                              const PrmLine         &line,
                              const Names           &known) const
  {
    const std::string what = line.is_section ? "section" : "parameter";
    const std::string opening =
      source.place(line) + ": the " + what + " '" + line.path + "' is ";
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
      catch (const dealii::ParameterHandler::ExcValueDoesNotMatchPattern &)
        {
          return false;
        }
      catch (const dealii::ExceptionBase &)
        {
          // An expression is a text too.
          return true;
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
  ParameterFile::declare(ParameterOwner &root)
  {
    root.declare_parameters(prm);
    do
      set_known_values();
    while (extend(root));
  }



  void
  ParameterFile::parse(ParameterOwner &root, const MakeRoot &make_root)
  {
    check_any();
    declare(root);
    check_names(make_root);
    root.check_parameters();
  }



  void
  ParameterFile::read_ahead(ParameterOwner &part) const
  {
    ParameterFile file;
    file.sources = sources;
    part.declare_parameters(file.prm);
    file.set_known_values();
  }



  const std::vector<std::string> &
  ParameterFile::unused() const
  {
    return unused_names;
  }



  // Not by ParameterHandler::set(), which would change what the run uses.
  void
  ParameterFile::print_resolved(std::ostream &out, const Values &instead) const
  {
    std::ostringstream text;
    prm.print_parameters(text, short_style);
    std::map<unsigned int, std::string> changed;
    for (const PrmLine &line : scan_prm(text.str()))
      if (const auto value = instead.find(line.path);
          !line.is_section && value != instead.end())
        changed[line.number] = value->second;

    std::istringstream lines(text.str());
    std::string        line;
    for (unsigned int number = 1; std::getline(lines, line); ++number)
      {
        const auto value = changed.find(number);
        out << (value == changed.end() ?
                  line :
                  line.substr(0, line.find('=') + 1) + " " + value->second)
            << '\n';
      }
  }



  std::vector<ParameterEntry>
  ParameterFile::entries(const Values &instead) const
  {
    std::vector<ParameterEntry> entries = entries_of(prm);
    for (ParameterEntry &entry : entries)
      if (const auto value = instead.find(entry.path); value != instead.end())
        entry.value = value->second;
    return entries;
  }



  std::vector<InputFile>
  ParameterFile::input_files() const
  {
    std::vector<InputFile>           files;
    const dealii::Patterns::FileName one;
    for (const ParameterEntry &entry : entries())
      {
        if (entry.pattern.find(one.description()) == std::string::npos)
          continue;
        const auto names = entry.pattern == one.description() ?
                             std::vector<std::string>{entry.value} :
                             dealii::Utilities::split_string_list(entry.value);
        for (const std::string &name : names)
          if (!name.empty())
            files.push_back(look_at_input_file(entry.path, name));
      }
    return files;
  }



  void
  ParameterFile::print_reference(ParameterOwner &root, std::ostream &out)
  {
    dealii::ParameterHandler all;
    root.declare_parameters(all);
    while (root.extend_parameters(all, Extent::everything))
      ;
    // deal.II takes an output that fails for an error of the program.
    std::ostringstream text;
    all.print_parameters(text,
                         dealii::ParameterHandler::PRM |
                           dealii::ParameterHandler::KeepDeclarationOrder);
    out << text.str();
  }
} // namespace lumbricus
