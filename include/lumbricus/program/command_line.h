// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_program_command_line_h
#define lumbricus_program_command_line_h

#include <iosfwd>
#include <string>
#include <vector>

namespace lumbricus
{
  /** What the command line asks for. */
  struct CommandLine
  {
    /** Read the arguments. Throws ExcInput for what it does not know. */
    CommandLine(const int argc, char *const argv[]);

    bool                     help       = false;
    bool                     version    = false;
    bool                     parameters = false;
    bool                     check      = false;
    bool                     quiet      = false;
    bool                     verbose    = false;
    bool                     progress   = false;
    std::string              parameter_file;
    std::string              output_folder;
    std::string              restart_folder;
    std::vector<std::string> settings;
  };

  void
  print_help(std::ostream &out);

  void
  print_version(std::ostream &out);
} // namespace lumbricus

#endif
