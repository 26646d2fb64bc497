// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/item_lines.h>
#include <lumbricus/parameters/input_file.h>
#include <lumbricus/parameters/prm_scanner.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <limits>
#include <system_error>

namespace lumbricus
{
  namespace
  {
    const std::string advice =
      " Bring it back, or start the run from its parameter file.";

    // Whether it can stand in a parameter file and in a line of its own.
    bool
    can_be_written(const std::string &path)
    {
      return unfit_for_a_line(path).empty() &&
             std::none_of(path.begin(), path.end(), [](const char c) {
               return std::iscntrl(static_cast<unsigned char>(c));
             });
    }



    std::optional<Fingerprint>
    content_of(const std::string &file_name)
    {
      const auto found = fingerprint_of_file(file_name);
      return found ? std::optional<Fingerprint>(found->value()) : std::nullopt;
    }
  } // namespace



  InputFile
  look_at_input_file(const std::string &parameter, const std::string &name)
  {
    std::error_code error;
    InputFile       file;
    file.parameter = parameter;
    file.name      = name;
    file.path      = std::filesystem::canonical(name, error).string();
    if (error || !can_be_written(file.path))
      file.path.clear();
    file.content = content_of(name);
    return file;
  }



  std::string
  to_text(const std::vector<InputFile> &files)
  {
    std::string text;
    for (const InputFile &file : files)
      text += "parameter " + file.parameter + "\nname " + file.name +
              "\npath " + file.path + "\ncontent " +
              (file.content ? std::to_string(file.content->size) + " " +
                                std::to_string(file.content->checksum) :
                              "none") +
              "\n";
    return text;
  }



  std::vector<InputFile>
  read_input_files(const std::string &text)
  {
    ItemLines  lines(text);
    const auto need = [&lines](const std::string &item) {
      if (lines.item() != item)
        lines.fail();
    };
    const auto rest_of_next = [&](const std::string &item) {
      AssertThrow(lines.next(), ExcDamaged("ends too early."));
      need(item);
      return lines.get_rest();
    };

    std::vector<InputFile> files;
    while (lines.next())
      {
        InputFile file;
        need("parameter");
        file.parameter = lines.get_rest();
        file.name      = rest_of_next("name");
        file.path      = rest_of_next("path");
        AssertThrow(lines.next(), ExcDamaged("ends too early."));
        need("content");
        const std::string size = lines.get_word();
        if (size != "none")
          {
            ItemLines numbers("content " + size + " " + lines.get_rest() +
                              "\n");
            numbers.next();
            Fingerprint content;
            content.size =
              numbers.get_count(std::numeric_limits<std::uintmax_t>::max());
            content.checksum =
              numbers.get_count(std::numeric_limits<std::uint32_t>::max());
            numbers.next();
            file.content = content;
          }
        if (file.name.empty() || !can_be_written(file.name) ||
            (!file.path.empty() && !can_be_written(file.path)))
          lines.fail();
        files.push_back(file);
      }
    return files;
  }



  std::string
  find_again(const InputFile &file)
  {
    const std::string begin = "The file '" + file.name + "' (parameter '" +
                              file.parameter + "') ";
    AssertThrow(file.content.has_value(),
                ExcInput(begin + "cannot be compared with what it was at the "
                                 "checkpoint, because it was no regular file. "
                                 "Start the run from its parameter file."));

    bool there = false;
    for (const std::string &name : {file.name, file.path})
      if (const auto content = content_of(name))
        {
          if (*content == *file.content)
            return name;
          there = true;
        }
    AssertThrow(!there,
                ExcInput(begin + "is not the one that the checkpoint was made "
                                 "with: it has changed since." +
                         advice));
    AssertThrow(false,
                ExcInput(begin +
                         "is not there any more, neither from the working "
                         "directory nor at '" +
                         file.path + "'." + advice));
    return "";
  }
} // namespace lumbricus
