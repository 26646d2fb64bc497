// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef lumbricus_parameters_parameter_source_h
#define lumbricus_parameters_parameter_source_h

#include <lumbricus/parameters/prm_scanner.h>

#include <string>
#include <vector>

namespace lumbricus
{
  /** Text of a parameter file, and where it is from: a .prm file without those
   * it includes, a JSON file, or a setting on the command line. */
  struct ParameterSource
  {
    /** What messages call it. */
    std::string name;
    /** As in a .prm file, without lines that include another. */
    std::string text;
    /** Whether users know its lines: it is not from a setting or JSON. */
    bool has_lines;
    /** Whether it is from the command line. */
    bool is_setting;
    /** What scan_prm() finds in the text. */
    std::vector<PrmLine> lines = {};

    /** The place of a line, for messages: "file.prm, line 3". */
    std::string
    place(const PrmLine &line) const;
  };

  /**
   * A file and those it includes, each behind those that it includes itself.
   * Throws ExcInput where one cannot be read, is no text or JSON, includes
   * itself, has a line that is none, or is more than InputLimits allow.
   */
  std::vector<ParameterSource>
  read_parameter_file(const std::string &file_name);

  /** @p text, which ParameterFile::print_resolved() wrote to a file of this
   * name: it includes nothing. Throws ExcInput. */
  ParameterSource
  resolved_source(const std::string &file_name, const std::string &text);

  /** A setting "Section/Subsection/Name=value". Throws ExcInput. */
  ParameterSource
  read_setting(const std::string &setting);
} // namespace lumbricus

#endif
