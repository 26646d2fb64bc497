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

    bool                     help       = false; ///< --help
    bool                     version    = false; ///< --version
    bool                     parameters = false; ///< --parameters, perhaps of a file
    bool                     check      = false; ///< --check
    bool                     values     = false; ///< --values, a check that says them
    bool                     quiet      = false; ///< --quiet
    bool                     verbose    = false; ///< --verbose
    bool                     progress   = false; ///< --progress
    std::string              parameter_file;     ///< empty with --restart
    std::string              output_folder;      ///< of --output, or empty
    std::string              restart_folder;     ///< of --restart, or empty
    std::vector<std::string> settings;           ///< of --set, in their order
  };

  /** Write what --help says: the options and exit codes. */
  void
  print_help(std::ostream &out);

  /** Write the versions of the program and of deal.II, and the build type. */
  void
  print_version(std::ostream &out);
} // namespace lumbricus

#endif
