// SPDX-License-Identifier: LGPL-2.1-or-later
#include <lumbricus/core/exceptions.h>
#include <lumbricus/core/input_file.h>
#include <lumbricus/geometry/msh_lines.h>

#include <deal.II/base/utilities.h>

namespace lumbricus
{
  const std::string MshLines::how_to_write =
    "Write it with 'Mesh.MshFileVersion = 4.1;' and 'Mesh.Binary = 0;'.";



  MshLines::MshLines(const std::string &parameter, const std::string &file_name)
    : in(open_input_file(file_name))
    , begin("Parameter '" + parameter + "': the mesh file '" + file_name + "'")
  {
    if (!in)
      fail(" cannot be read. Give the path of a .msh file of Gmsh, from the "
           "working directory.");
  }



  bool
  MshLines::next()
  {
    while (std::getline(in, line))
      {
        ++number;
        if (line.find_first_not_of(" \t\r") != std::string::npos)
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
  MshLines::first_word() const
  {
    const std::string text = trimmed();
    return text.substr(0, text.find_first_of(" \t"));
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
