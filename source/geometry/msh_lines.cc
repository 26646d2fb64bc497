// SPDX-License-Identifier: LGPL-2.1-or-later
#include "msh_lines.h"

#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/number_in_text.h>
#include <lumbricus/core/readable_file.h>
#include <lumbricus/core/text_lines.h>

#include <deal.II/base/utilities.h>

#include <limits>

namespace lumbricus
{
  const std::string MshLines::how_to_write =
    "Write it with 'Mesh.MshFileVersion = 4.1;' and 'Mesh.Binary = 0;'.";



  MshLines::MshLines(const std::string &parameter, const std::string &file_name)
    : in(open_input_file(file_name))
    , begin(about_parameter(parameter, ": the mesh file '" + file_name + "'"))
  {
    if (!in)
      fail(" cannot be read. Give the path of a .msh file of Gmsh, from the "
           "working directory.");
    skip_byte_order_mark(in);
  }



  bool
  MshLines::next()
  {
    while (read_line(in, line))
      {
        ++number;
        if (line.find_first_not_of(" \t") != std::string::npos)
          {
            words.clear();
            words.str(line);
            return true;
          }
      }
    return false;
  }



  void
  MshLines::need()
  {
    if (!next())
      fail(" ends too early, in line " + std::to_string(number) +
           ". Write it again.");
  }



  std::string
  MshLines::trimmed() const
  {
    return dealii::Utilities::trim(line);
  }



  std::string
  MshLines::shown() const
  {
    constexpr std::size_t most = 60;
    const std::string     text = trimmed();
    return "'" + text.substr(0, most) + (text.size() > most ? "..." : "") + "'";
  }



  std::string
  MshLines::first_word() const
  {
    const std::string text = trimmed();
    return text.substr(0, text.find_first_of(" \t"));
  }



  template <typename T>
  T
  MshLines::get()
  {
    T           value;
    std::string word;
    words >> word;
    if (!read_number(word, value))
      fail_in_line(shown() + ", has no number where one belongs" +
                   (word.empty() ? "" : ", but '" + word.substr(0, 40) + "'") +
                   ". " + how_to_write);
    return value;
  }



  double
  MshLines::get_number()
  {
    return get<double>();
  }



  int
  MshLines::get_integer()
  {
    using Limits     = std::numeric_limits<int>;
    const auto value = get<long long>();
    if (value <= Limits::min() || value > Limits::max())
      fail_in_line("has the number " + std::to_string(value) +
                   ", which is too large. " + how_to_write);
    return value;
  }



  std::size_t
  MshLines::get_count()
  {
    const auto value = get<long long>();
    if (value < 0)
      fail_in_line("has a number < 0 where none belongs. " + how_to_write);
    return value;
  }



  void
  MshLines::need_end_of_line()
  {
    std::string word;
    if (words >> word)
      fail_in_line(shown() + ", goes on with '" + word.substr(0, 40) +
                   "' where it should end. " + how_to_write);
  }



  void
  MshLines::begin_section(const std::string &name)
  {
    if (!sections.insert(name).second)
      fail_in_line("begins a second section '" + name +
                   "'. Write one mesh into a file.");
    need();
  }



  void
  MshLines::end_section(const std::string &name)
  {
    const std::string end = "$End" + name.substr(1);
    need();
    if (trimmed() != end)
      fail_in_line(shown() + ", comes where the section '" + name +
                   "' should end with '" + end +
                   "' by the numbers it gives. Write the file again.");
  }



  void
  MshLines::check_count(const std::string &what,
                        const std::size_t  read,
                        const std::size_t  said) const
  {
    if (read != said)
      fail_in_line("is the last of " + std::to_string(read) + " " + what +
                   ", but the first line of the section says " +
                   std::to_string(said) + ". Write the file again.");
  }



  bool
  MshLines::had_section(const std::string &name) const
  {
    return sections.count(name) > 0;
  }



  void
  MshLines::fail(const std::string &what) const
  {
    throw ExcInput(begin + what);
  }



  void
  MshLines::fail_in_line(const std::string &what) const
  {
    fail(", line " + std::to_string(number) + ", " + what);
  }
} // namespace lumbricus
