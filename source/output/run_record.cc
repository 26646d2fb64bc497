// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/item_lines.h>
#include <lumbricus/output/run_record.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <limits>
#include <ostream>
#include <random>
#include <sstream>
#include <system_error>

namespace lumbricus
{
  namespace
  {
    namespace files_on_disk = std::filesystem;

    const std::string record_line =
      "# What a run of lumbricus has written to this folder, and so may "
      "overwrite.\n";

    // 128 bits.
    std::string
    new_id()
    {
      std::random_device random;
      std::ostringstream id;
      for (unsigned int i = 0; i < 4; ++i)
        id << std::hex << std::setw(8) << std::setfill('0') << random();
      return id.str();
    }



    bool
    consists_of(const std::string &text, const std::string &letters)
    {
      return text.find_first_not_of(letters) == std::string::npos;
    }



    // Names that cannot lead out of the folder: "segments.csv", "vtu/a.vtu".
    bool
    is_name_of_a_file(const std::string &name)
    {
      const auto slash    = name.find('/');
      const auto is_plain = [](const std::string &part) {
        return !part.empty() && part.front() != '.' &&
               consists_of(part,
                           "abcdefghijklmnopqrstuvwxyz"
                           "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.");
      };
      return slash == std::string::npos ?
               is_plain(name) :
               is_plain(name.substr(0, slash)) &&
                 is_plain(name.substr(slash + 1));
    }



    std::string
    file_line(const std::string &name)
    {
      return "file " + name + "\n";
    }



    std::string
    parameters_line(const Fingerprint &content)
    {
      return "parameters " + std::to_string(content.size) + " " +
             std::to_string(content.checksum) + "\n";
    }



    [[noreturn]] void
    fail(const std::string &path, const std::string &reason)
    {
      throw ExcSolveFailed("The file '" + path +
                           "' cannot be written: " + reason + ".");
    }
  } // namespace



  const std::string RunRecord::file_name = "lumbricus.run";



  void
  RunRecord::read(const std::string &folder)
  {
    *this = RunRecord();
    path  = folder + "/" + file_name;
    std::error_code error;
    const auto      status = files_on_disk::symlink_status(path, error);
    if (!files_on_disk::exists(status))
      return;

    std::string what = "is not a record of what a run has written.";
    if (files_on_disk::is_regular_file(status))
      try
        {
          std::ifstream in(path, std::ios::binary);
          std::string   text(std::istreambuf_iterator<char>(in), {});
          if (text.compare(0, record_line.size(), record_line) == 0)
            {
              // The last line may have been cut short.
              complete_size      = text.rfind('\n') + 1;
              ends_in_the_middle = complete_size < text.size();
              read_lines(text.substr(record_line.size(),
                                     complete_size - record_line.size()));
              what.clear();
            }
        }
      catch (const ExcDamaged &exception)
        {
          what = plain_message(exception);
        }
    AssertThrow(what.empty(),
                ExcInput("The file '" + path + "' " + what +
                         " Nothing in that folder is changed without it. Move "
                         "it away, or choose another folder with "
                         "'Output/Folder' or --output."));
  }



  void
  RunRecord::read_lines(const std::string &text)
  {
    constexpr auto most = std::numeric_limits<std::uint32_t>::max();
    ItemLines      lines(text);
    while (lines.next())
      if (lines.item() == "run")
        {
          id = lines.get_word();
          if (id.size() != 32 || !consists_of(id, "0123456789abcdef"))
            lines.fail();
        }
      else if (lines.item() == "file")
        {
          const std::string name = lines.get_rest();
          if (!is_name_of_a_file(name))
            lines.fail();
          all_files.insert(name);
        }
      else if (lines.item() == "checkpoint")
        {
          const std::string name = lines.get_word();
          if (!consists_of(name, "0123456789"))
            lines.fail();
          all_checkpoints.insert(name);
        }
      else if (lines.item() == "parameters")
        {
          Fingerprint content;
          content.size =
            lines.get_count(std::numeric_limits<std::uintmax_t>::max());
          content.checksum = lines.get_count(most);
          parameters.push_back(content);
        }
      else
        lines.fail();
    AssertThrow(!id.empty(), ExcDamaged("does not have the number of a run."));
  }



  void
  RunRecord::begin(const std::string              &folder,
                   const std::vector<std::string> &files)
  {
    // What parameters.prm was it still is, until it is overwritten.
    const std::vector<Fingerprint> before = parameters;
    *this                                 = RunRecord();
    path                                  = folder + "/" + file_name;
    id                                    = new_id();
    parameters                            = before;
    all_files.insert(files.begin(), files.end());

    const std::string temporary = path + ".incomplete";
    std::remove(temporary.c_str());
    std::ofstream out(temporary, std::ios::binary);
    out << record_line << "run " << id << '\n';
    for (const Fingerprint &content : parameters)
      out << parameters_line(content);
    for (const std::string &name : all_files)
      out << file_line(name);
    out.close();
    if (!out || std::rename(temporary.c_str(), path.c_str()) != 0)
      {
        const std::string reason = std::strerror(errno);
        std::remove(temporary.c_str());
        fail(path, reason);
      }
  }



  const std::string &
  RunRecord::run_id() const
  {
    return id;
  }



  const std::set<std::string> &
  RunRecord::files() const
  {
    return all_files;
  }



  const std::set<std::string> &
  RunRecord::checkpoints() const
  {
    return all_checkpoints;
  }



  bool
  RunRecord::has_parameters(const Fingerprint &content) const
  {
    return std::count(parameters.begin(), parameters.end(), content) > 0;
  }



  void
  RunRecord::add_files(const std::vector<std::string> &names)
  {
    std::string lines;
    for (const std::string &name : names)
      {
        Assert(is_name_of_a_file(name), dealii::ExcInternalError());
        if (all_files.count(name) == 0)
          lines += file_line(name);
      }
    append(lines);
    all_files.insert(names.begin(), names.end());
  }



  void
  RunRecord::add_checkpoint(const std::string &name)
  {
    if (all_checkpoints.count(name) == 0)
      append("checkpoint " + name + "\n");
    all_checkpoints.insert(name);
  }



  void
  RunRecord::add_parameters(const Fingerprint &content)
  {
    if (has_parameters(content))
      return;
    append(parameters_line(content));
    parameters.push_back(content);
  }



  void
  RunRecord::append(const std::string &lines)
  {
    if (lines.empty())
      return;
    std::error_code error;
    const auto      before = files_on_disk::file_size(path, error);
    if (error)
      fail(path, error.message());
    if (ends_in_the_middle)
      files_on_disk::resize_file(path, complete_size, error);
    std::ofstream out(path, std::ios::binary | std::ios::app);
    out << lines << std::flush;
    if (error || !out)
      {
        const std::string reason =
          error ? error.message() : std::strerror(errno);
        out.close();
        files_on_disk::resize_file(path, before, error);
        fail(path, reason);
      }
    ends_in_the_middle = false;
  }
} // namespace lumbricus
