// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/input_limits.h>
#include <lumbricus/core/readable_file.h>
#include <lumbricus/core/text_lines.h>
#include <lumbricus/core/user_text.h>
#include <lumbricus/parameters/json_parameters.h>
#include <lumbricus/parameters/parameter_source.h>

#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <sstream>
#include <system_error>

namespace lumbricus
{
  namespace
  {
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



    // All of a file, but not more than @p most bytes and one.
    std::string
    bytes_of(std::istream &in, const std::size_t most)
    {
      std::string all(most + 1, '\0');
      in.read(&all[0], all.size());
      all.resize(in.gcount());
      return all;
    }



    bool
    is_text(const std::string &content)
    {
      return std::none_of(content.begin(), content.end(), [](const char c) {
        return std::iscntrl(static_cast<unsigned char>(c)) && !std::isspace(c);
      });
    }



    // A source whose lines are those of a parameter file.
    ParameterSource
    scanned(ParameterSource source)
    {
      const PrmMistake mistake = first_mistake(source.text);
      AssertThrow(mistake.line == 0,
                  ExcInput(source.place({mistake.line, "", false}) + ": " +
                           mistake.what +
                           "\nThe lines of a parameter file are 'set Name = "
                           "value', 'subsection Name' and, for each of "
                           "these, 'end'; # starts a comment."));
      source.lines = scan_prm(source.text);
      return source;
    }



    // Follows the 'include' lines from file to file.
    class FileReader
    {
    public:
      void
      read(const std::string &file_name);

      std::vector<ParameterSource> sources;

    private:
      std::string
      content_of(const std::string &file_name);

      std::vector<std::string> being_read;
      unsigned int             n_files = 0;
      std::size_t              n_bytes = 0;
    };



    std::string
    FileReader::content_of(const std::string &file_name)
    {
      const std::string quoted = "'" + shortened(file_name, 200) + "'";
      const std::string reason = why_unreadable(file_name);
      AssertThrow(reason.empty(),
                  ExcInput(
                    "The parameter file " + quoted +
                    (being_read.empty() ?
                       std::string() :
                       ", which '" + shortened(being_read.back(), 200) +
                         "' includes,") +
                    " cannot be read: " + reason +
                    ". Give the path of a .prm or .json file" +
                    (being_read.empty() ?
                       "; the gallery in parameters/ has some." :
                       ", from the folder of the file that includes it.")));
      AssertThrow(++n_files <= InputLimits::files &&
                    being_read.size() < InputLimits::includes,
                  ExcInput("The parameter file " + quoted + " is one of more "
                           "than " +
                           std::to_string(n_files > InputLimits::files ?
                                            InputLimits::files :
                                            InputLimits::includes) +
                           " that include each other. Put what they say into "
                           "fewer files."));
      std::ifstream     in    = open_input_file(file_name);
      const std::string bytes = bytes_of(in, InputLimits::bytes - n_bytes);
      n_bytes += bytes.size();
      AssertThrow(n_bytes <= InputLimits::bytes,
                  ExcInput("The parameter file " + quoted +
                           ", with those before it, is larger than the " +
                           std::to_string(InputLimits::bytes >> 20) +
                           " MiB that parameter files may have. Give a .prm "
                           "or .json file."));
      std::istringstream in_memory(bytes);
      const std::string  content = text_of(in_memory);
      AssertThrow(is_text(content),
                  ExcInput("The parameter file " + quoted +
                           " is not plain text. Give a .prm or .json file, in "
                           "UTF-8."));
      return content;
    }



    void
    FileReader::read(const std::string &file_name)
    {
      std::istringstream in(content_of(file_name));
      if (std::filesystem::path(file_name).extension() == ".json")
        {
          sources.push_back(
            scanned({file_name, prm_from_json(file_name, in), false, false}));
          return;
        }
      std::error_code   error;
      const std::string file =
        std::filesystem::canonical(file_name, error).string();
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
      sources.push_back(scanned({file_name, text, true, false}));
    }
  } // namespace



  std::string
  ParameterSource::place(const PrmLine &line) const
  {
    return has_lines ? name + ", line " + std::to_string(line.number) : name;
  }



  std::vector<ParameterSource>
  read_parameter_file(const std::string &file_name)
  {
    FileReader reader;
    reader.read(file_name);
    return reader.sources;
  }



  ParameterSource
  resolved_source(const std::string &file_name, const std::string &text)
  {
    AssertThrow(is_text(text),
                ExcInput("The parameter file '" + file_name +
                         "' is not plain text."));
    return scanned({file_name, text, true, false});
  }



  ParameterSource
  read_setting(const std::string &setting)
  {
    const std::string        quoted = "--set '" + shortened(setting) + "'";
    const auto               equals = setting.find('=');
    const std::string        full   = setting.substr(0, equals);
    std::vector<std::string> path   = split_path(full + "/");
    AssertThrow(equals != std::string::npos && !path.empty() &&
                  std::count(path.begin(), path.end(), "") == 0,
                ExcInput(quoted +
                         " is not of the form --set \"Section/Name=value\"."));
    const std::string unfit = unfit_for_a_line(setting);
    AssertThrow(unfit.empty(),
                ExcInput(quoted + " has " + unfit +
                         " in parameter files. Leave it out."));
    const std::string name = path.back();
    path.pop_back();

    std::string text;
    for (const std::string &section : path)
      text += "subsection " + section + "\n";
    text += "set " + name + " =" + setting.substr(equals + 1) + "\n";
    for (unsigned int i = 0; i < path.size(); ++i)
      text += "end\n";
    return scanned({quoted, text, false, true});
  }
} // namespace lumbricus
